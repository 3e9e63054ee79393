#include "BufferTexels.h"

#include <vtkOpenGLState.h>

#include "OpenGL.h"

namespace shadow
{

std::size_t BufferTexels::findMost()
{
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  return static_cast<std::size_t>(most);
}

bool BufferTexels::attach(unsigned int buffer, std::size_t texels)
{
  if (texels > findMost())
  {
    return false;
  }
  if (this->texture != 0 && this->attached == buffer)
  {
    return true;
  }
  this->release();
  GLint before = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_BUFFER, &before);
  glGenTextures(1, &this->texture);
  glBindTexture(GL_TEXTURE_BUFFER, this->texture);
  const GLenum single = this->number == Number::Float ? GL_R32F : GL_R32UI;
  glTexBuffer(GL_TEXTURE_BUFFER, this->number == Number::Float4 ? GL_RGBA32F : single, buffer);
  glBindTexture(GL_TEXTURE_BUFFER, static_cast<GLuint>(before));
  this->attached = buffer;
  return true;
}

void BufferTexels::bind(vtkOpenGLState* state, unsigned int program, int unit, const char* sampler) const
{
  state->vtkglActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_BUFFER, this->texture);
  glUniform1i(glGetUniformLocation(program, sampler), unit);
}

void BufferTexels::unbind(vtkOpenGLState* state, int unit)
{
  state->vtkglActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_BUFFER, 0);
}

void BufferTexels::release(bool contextLost)
{
  if (!contextLost && this->texture != 0)
  {
    glDeleteTextures(1, &this->texture);
  }
  this->texture = this->attached = 0;
}

} // namespace shadow
