/* GLX as far as a GL loader asks for it, answered by OSMesa: functions come from OSMesaGetProcAddress, there
 * is no display. Must stand before the system's libGLX and libOpenGL in symbol order, with libOSMesa. */
#include <GL/osmesa.h>
#include <stddef.h>
#include <string.h>

typedef void (*Function)(void);

void* glXGetCurrentDisplay(void)
{
  static int display;
  return &display;
}

int glXQueryVersion(void* display, int* major, int* minor)
{
  (void)display;
  *major = 1;
  *minor = 4;
  return 1;
}

const char* glXGetClientString(void* display, int name)
{
  (void)display;
  (void)name;
  return "";
}

Function glXGetProcAddressARB(const unsigned char* name)
{
  /* Loaders ask also for GLX itself by name. */
  const char* text = (const char*)name;
  if (strcmp(text, "glXGetCurrentDisplay") == 0)
  {
    return (Function)glXGetCurrentDisplay;
  }
  if (strcmp(text, "glXQueryVersion") == 0)
  {
    return (Function)glXQueryVersion;
  }
  if (strcmp(text, "glXGetClientString") == 0)
  {
    return (Function)glXGetClientString;
  }
  return (Function)OSMesaGetProcAddress(text);
}
