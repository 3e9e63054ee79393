#ifndef GLFunctions_h
#define GLFunctions_h

/* Where the GL of this process comes from. Part of libvtkShadowGLX, which answers everything that VTK and its
 * GL loader ask of GL and GLX by symbol, and passes it on to the library that was chosen when the program
 * ran. */

#ifdef __cplusplus
extern "C"
{
#endif

  typedef void (*vtkShadowGLFunction)(void);
  typedef vtkShadowGLFunction (*vtkShadowGLLookup)(const char* name);

  /* Sets where GL functions are looked up. Once a process, before its first context is made current: a
   * function that was found is kept. */
  void vtkShadowSetGLLookup(vtkShadowGLLookup lookup);

  /* The address of a GL function; null before vtkShadowSetGLLookup() and for a name that the GL does not
   * know. */
  vtkShadowGLFunction vtkShadowGetGLFunction(const char* name);

#ifdef __cplusplus
}
#endif

#endif
