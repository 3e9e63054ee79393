/* GLX as far as a GL loader asks for it, answered without a display: functions come from the GL that was
 * chosen. Must stand before the system's libGLX in symbol order. */
#include <stddef.h>
#include <string.h>

#include "GLFunctions.h"

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

vtkShadowGLFunction glXGetProcAddressARB(const unsigned char* name)
{
  /* Loaders ask also for GLX itself by name. */
  const char* text = (const char*)name;
  if (strcmp(text, "glXGetCurrentDisplay") == 0)
  {
    return (vtkShadowGLFunction)glXGetCurrentDisplay;
  }
  if (strcmp(text, "glXQueryVersion") == 0)
  {
    return (vtkShadowGLFunction)glXQueryVersion;
  }
  if (strcmp(text, "glXGetClientString") == 0)
  {
    return (vtkShadowGLFunction)glXGetClientString;
  }
  return vtkShadowGetGLFunction(text);
}
