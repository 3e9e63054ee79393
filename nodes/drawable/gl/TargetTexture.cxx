#include "TargetTexture.h"

#include "OpenGL.h"

namespace shadow
{

unsigned int textureTargetOf(int samples)
{
  return samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
}

unsigned int makeTargetTexture(int width, int height, int samples, unsigned int internalFormat,
                               unsigned int format, unsigned int type)
{
  const GLenum target = textureTargetOf(samples);
  GLint before = 0;
  glGetIntegerv(samples > 1 ? GL_TEXTURE_BINDING_2D_MULTISAMPLE : GL_TEXTURE_BINDING_2D, &before);
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(target, texture);
  if (samples > 1)
  {
    glTexImage2DMultisample(target, samples, internalFormat, width, height, GL_TRUE);
  }
  else
  {
    glTexImage2D(target, 0, static_cast<GLint>(internalFormat), width, height, 0, format, type, nullptr);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
  }
  glBindTexture(target, static_cast<GLuint>(before));
  return texture;
}

} // namespace shadow
