#include "RefusingGL.h"

#include <dlfcn.h>

#include "OpenGL.h"

namespace
{

int texelLimit = 0; ///< 0: the GL's own

using GetIntegers = void (*)(GLenum, GLint*);

decltype(glCheckFramebufferStatus) checkFramebuffer = nullptr;

GLenum GLAPIENTRY refuseFramebuffer(GLenum)
{
  return GL_FRAMEBUFFER_UNSUPPORTED;
}

decltype(glGetShaderiv) askShader = nullptr;

void GLAPIENTRY refuseShader(GLuint shader, GLenum name, GLint* value)
{
  askShader(shader, name, value);
  *value = name == GL_COMPILE_STATUS ? GL_FALSE : *value;
}

} // namespace

// Stands before the GL's own, for the libraries as well.
extern "C" void GLAPIENTRY glGetIntegerv(GLenum name, GLint* values)
{
  static const auto ask = reinterpret_cast<GetIntegers>(dlsym(RTLD_NEXT, "glGetIntegerv"));
  ask(name, values);
  if (name == GL_MAX_TEXTURE_BUFFER_SIZE && texelLimit > 0)
  {
    *values = texelLimit;
  }
}

namespace shadow::test
{

TexelLimit::TexelLimit(int texels)
{
  texelLimit = texels;
}

TexelLimit::~TexelLimit()
{
  texelLimit = 0;
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

ShaderRefusal::ShaderRefusal()
{
  askShader = glGetShaderiv;
  glGetShaderiv = &refuseShader;
}

ShaderRefusal::~ShaderRefusal()
{
  glGetShaderiv = askShader;
}

} // namespace shadow::test
