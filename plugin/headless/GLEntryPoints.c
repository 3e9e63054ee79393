/* The functions of GL 1.0 and 1.1 that a core profile has. VTK calls these by symbol, and all later ones
 * through pointers that its loader asks for. Each is passed on to the GL that was chosen, so that one program
 * can draw through OSMesa or through EGL. Must stand before the system's libOpenGL in symbol order. */
#include <GL/gl.h>
#include <stddef.h>

#include "GLFunctions.h"

static vtkShadowGLLookup chosenLookup = NULL;

void vtkShadowSetGLLookup(vtkShadowGLLookup lookup)
{
  chosenLookup = lookup;
}

vtkShadowGLFunction vtkShadowGetGLFunction(const char* name)
{
  return chosenLookup != NULL ? chosenLookup(name) : NULL;
}

/* Without a GL a call does nothing, as GL calls without a context do. */
#define PASS_ON(Result, name, parameters, arguments)                                                         \
  Result name parameters                                                                                     \
  {                                                                                                          \
    typedef Result(*Entry) parameters;                                                                       \
    static Entry entry = NULL;                                                                               \
    if (entry == NULL)                                                                                       \
    {                                                                                                        \
      entry = (Entry)vtkShadowGetGLFunction(#name);                                                          \
      if (entry == NULL)                                                                                     \
      {                                                                                                      \
        return (Result)0;                                                                                    \
      }                                                                                                      \
    }                                                                                                        \
    return entry arguments;                                                                                  \
  }

/* State. */
PASS_ON(void, glBlendFunc, (GLenum source, GLenum destination), (source, destination))
PASS_ON(void, glClear, (GLbitfield mask), (mask))
PASS_ON(void, glClearColor, (GLclampf r, GLclampf g, GLclampf b, GLclampf a), (r, g, b, a))
PASS_ON(void, glClearDepth, (GLclampd depth), (depth))
PASS_ON(void, glClearStencil, (GLint value), (value))
PASS_ON(void, glColorMask, (GLboolean r, GLboolean g, GLboolean b, GLboolean a), (r, g, b, a))
PASS_ON(void, glCullFace, (GLenum mode), (mode))
PASS_ON(void, glDepthFunc, (GLenum function), (function))
PASS_ON(void, glDepthMask, (GLboolean flag), (flag))
PASS_ON(void, glDepthRange, (GLclampd nearest, GLclampd farthest), (nearest, farthest))
PASS_ON(void, glDisable, (GLenum capability), (capability))
PASS_ON(void, glDrawBuffer, (GLenum mode), (mode))
PASS_ON(void, glEnable, (GLenum capability), (capability))
PASS_ON(void, glFinish, (void), ())
PASS_ON(void, glFlush, (void), ())
PASS_ON(void, glFrontFace, (GLenum mode), (mode))
PASS_ON(void, glHint, (GLenum target, GLenum mode), (target, mode))
PASS_ON(void, glLineWidth, (GLfloat width), (width))
PASS_ON(void, glLogicOp, (GLenum code), (code))
PASS_ON(void, glPixelStoref, (GLenum name, GLfloat value), (name, value))
PASS_ON(void, glPixelStorei, (GLenum name, GLint value), (name, value))
PASS_ON(void, glPointSize, (GLfloat size), (size))
PASS_ON(void, glPolygonMode, (GLenum face, GLenum mode), (face, mode))
PASS_ON(void, glPolygonOffset, (GLfloat factor, GLfloat units), (factor, units))
PASS_ON(void, glReadBuffer, (GLenum mode), (mode))
PASS_ON(void, glScissor, (GLint x, GLint y, GLsizei width, GLsizei height), (x, y, width, height))
PASS_ON(void, glStencilFunc, (GLenum function, GLint reference, GLuint mask), (function, reference, mask))
PASS_ON(void, glStencilMask, (GLuint mask), (mask))
PASS_ON(void, glStencilOp, (GLenum fail, GLenum depthFail, GLenum pass), (fail, depthFail, pass))
PASS_ON(void, glViewport, (GLint x, GLint y, GLsizei width, GLsizei height), (x, y, width, height))

/* Questions. */
PASS_ON(void, glGetBooleanv, (GLenum name, GLboolean* values), (name, values))
PASS_ON(void, glGetDoublev, (GLenum name, GLdouble* values), (name, values))
PASS_ON(GLenum, glGetError, (void), ())
PASS_ON(void, glGetFloatv, (GLenum name, GLfloat* values), (name, values))
PASS_ON(void, glGetIntegerv, (GLenum name, GLint* values), (name, values))
PASS_ON(void, glGetPointerv, (GLenum name, GLvoid** values), (name, values))
PASS_ON(const GLubyte*, glGetString, (GLenum name), (name))
PASS_ON(GLboolean, glIsEnabled, (GLenum capability), (capability))

/* Textures. */
PASS_ON(void, glBindTexture, (GLenum target, GLuint texture), (target, texture))
PASS_ON(void, glCopyTexImage1D,
        (GLenum target, GLint level, GLenum format, GLint x, GLint y, GLsizei width, GLint border),
        (target, level, format, x, y, width, border))
PASS_ON(void, glCopyTexImage2D,
        (GLenum target, GLint level, GLenum format, GLint x, GLint y, GLsizei width, GLsizei height,
         GLint border),
        (target, level, format, x, y, width, height, border))
PASS_ON(void, glCopyTexSubImage1D, (GLenum target, GLint level, GLint toX, GLint x, GLint y, GLsizei width),
        (target, level, toX, x, y, width))
PASS_ON(void, glCopyTexSubImage2D,
        (GLenum target, GLint level, GLint toX, GLint toY, GLint x, GLint y, GLsizei width, GLsizei height),
        (target, level, toX, toY, x, y, width, height))
PASS_ON(void, glDeleteTextures, (GLsizei count, const GLuint* textures), (count, textures))
PASS_ON(void, glGenTextures, (GLsizei count, GLuint* textures), (count, textures))
PASS_ON(void, glGetTexImage, (GLenum target, GLint level, GLenum format, GLenum type, GLvoid* pixels),
        (target, level, format, type, pixels))
PASS_ON(void, glGetTexLevelParameterfv, (GLenum target, GLint level, GLenum name, GLfloat* values),
        (target, level, name, values))
PASS_ON(void, glGetTexLevelParameteriv, (GLenum target, GLint level, GLenum name, GLint* values),
        (target, level, name, values))
PASS_ON(void, glGetTexParameterfv, (GLenum target, GLenum name, GLfloat* values), (target, name, values))
PASS_ON(void, glGetTexParameteriv, (GLenum target, GLenum name, GLint* values), (target, name, values))
PASS_ON(GLboolean, glIsTexture, (GLuint texture), (texture))
PASS_ON(void, glTexImage1D,
        (GLenum target, GLint level, GLint internal, GLsizei width, GLint border, GLenum format, GLenum type,
         const GLvoid* pixels),
        (target, level, internal, width, border, format, type, pixels))
PASS_ON(void, glTexImage2D,
        (GLenum target, GLint level, GLint internal, GLsizei width, GLsizei height, GLint border,
         GLenum format, GLenum type, const GLvoid* pixels),
        (target, level, internal, width, height, border, format, type, pixels))
PASS_ON(void, glTexParameterf, (GLenum target, GLenum name, GLfloat value), (target, name, value))
PASS_ON(void, glTexParameterfv, (GLenum target, GLenum name, const GLfloat* values), (target, name, values))
PASS_ON(void, glTexParameteri, (GLenum target, GLenum name, GLint value), (target, name, value))
PASS_ON(void, glTexParameteriv, (GLenum target, GLenum name, const GLint* values), (target, name, values))
PASS_ON(void, glTexSubImage1D,
        (GLenum target, GLint level, GLint x, GLsizei width, GLenum format, GLenum type,
         const GLvoid* pixels),
        (target, level, x, width, format, type, pixels))
PASS_ON(void, glTexSubImage2D,
        (GLenum target, GLint level, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
         GLenum type, const GLvoid* pixels),
        (target, level, x, y, width, height, format, type, pixels))

/* Pixels and primitives. */
PASS_ON(void, glDrawArrays, (GLenum mode, GLint first, GLsizei count), (mode, first, count))
PASS_ON(void, glDrawElements, (GLenum mode, GLsizei count, GLenum type, const GLvoid* indices),
        (mode, count, type, indices))
PASS_ON(void, glReadPixels,
        (GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type, GLvoid* pixels),
        (x, y, width, height, format, type, pixels))
