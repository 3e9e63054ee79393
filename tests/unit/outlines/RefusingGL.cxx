#include "RefusingGL.h"

#include <dlfcn.h>

#include "OpenGL.h"

namespace
{

int texelLimit = 0; ///< 0: the GL's own

using GetIntegers = void (GLAPIENTRY*)(GLenum, GLint*);

decltype(glCheckFramebufferStatus) checkFramebuffer = nullptr;

GLenum GLAPIENTRY refuseFramebuffer(GLenum)
{
  return GL_FRAMEBUFFER_UNSUPPORTED;
}

decltype(glGetShaderiv) askShader = nullptr;
GLenum refusedType = 0; ///< of shaders; 0: all

void GLAPIENTRY refuseShader(GLuint shader, GLenum name, GLint* value)
{
  askShader(shader, name, value);
  GLint type = 0;
  askShader(shader, GL_SHADER_TYPE, &type);
  if (name == GL_COMPILE_STATUS && (refusedType == 0 || refusedType == static_cast<GLenum>(type)))
  {
    *value = GL_FALSE;
  }
}

void getLimited(GetIntegers ask, GLenum name, GLint* values)
{
  ask(name, values);
  if (name == GL_MAX_TEXTURE_BUFFER_SIZE && texelLimit > 0)
  {
    *values = texelLimit;
  }
}

#ifdef glGetIntegerv
// A loader that has a pointer for every function.
GetIntegers askIntegers = nullptr;

void GLAPIENTRY getIntegers(GLenum name, GLint* values)
{
  getLimited(askIntegers, name, values);
}
#endif

} // namespace

#ifndef glGetIntegerv
// Stands before the GL's own, for the libraries as well.
extern "C" void GLAPIENTRY glGetIntegerv(GLenum name, GLint* values)
{
  static const auto ask = reinterpret_cast<GetIntegers>(dlsym(RTLD_NEXT, "glGetIntegerv"));
  getLimited(ask, name, values);
}
#endif

namespace shadow::test
{

TexelLimit::TexelLimit(int texels)
{
  texelLimit = texels;
#ifdef glGetIntegerv
  askIntegers = glGetIntegerv;
  glGetIntegerv = &getIntegers;
#endif
}

TexelLimit::~TexelLimit()
{
  texelLimit = 0;
#ifdef glGetIntegerv
  glGetIntegerv = askIntegers;
#endif
}

FramebufferRefusal::FramebufferRefusal()
{
  checkFramebuffer = glCheckFramebufferStatus;
  glCheckFramebufferStatus = &refuseFramebuffer;
}

FramebufferRefusal::~FramebufferRefusal()
{
  glCheckFramebufferStatus = checkFramebuffer;
}

ShaderRefusal::ShaderRefusal(unsigned int type)
{
  refusedType = type;
  askShader = glGetShaderiv;
  glGetShaderiv = &refuseShader;
}

ShaderRefusal::~ShaderRefusal()
{
  glGetShaderiv = askShader;
}

} // namespace shadow::test
