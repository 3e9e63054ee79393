#include "CallerFramebuffer.h"

#include <algorithm>

#include "OpenGL.h"

namespace shadow
{

namespace
{

int getDepthParameter(GLenum parameter, bool ofDefault)
{
  GLint value = 0;
  glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, ofDefault ? GL_DEPTH : GL_DEPTH_ATTACHMENT,
                                        parameter, &value);
  return value;
}

} // namespace

CallerFramebuffer CallerFramebuffer::query()
{
  CallerFramebuffer caller;
  GLint value = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &value);
  caller.name = static_cast<unsigned int>(value);
  glGetIntegerv(GL_SAMPLES, &value);
  caller.samples = std::max(1, value);
  glGetIntegerv(GL_DRAW_BUFFER1, &value);
  caller.hasMoreColours = value != GL_NONE;
  const bool isDefault = caller.name == 0;
  caller.depthType = getDepthParameter(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, isDefault);
  if (caller.depthType == GL_NONE)
  {
    return caller;
  }
  if (!isDefault)
  {
    caller.depthName =
        static_cast<unsigned int>(getDepthParameter(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, false));
  }
  if (caller.depthType == GL_TEXTURE)
  {
    caller.depthLevel = getDepthParameter(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL, false);
  }
  caller.depthBits = getDepthParameter(GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, isDefault);
  caller.hasFloatDepth = getDepthParameter(GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, isDefault) == GL_FLOAT;
  caller.hasStencil = getDepthParameter(GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE, isDefault) > 0;
  return caller;
}

bool CallerFramebuffer::canShareDepth() const
{
  return this->depthType == GL_TEXTURE || this->depthType == GL_RENDERBUFFER;
}

void CallerFramebuffer::attachDepth() const
{
  if (this->depthType == GL_TEXTURE)
  {
    glFramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, this->depthName, this->depthLevel);
  }
  else
  {
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, this->depthName);
  }
}

unsigned int CallerFramebuffer::depthFormat() const
{
  if (this->hasFloatDepth)
  {
    return this->hasStencil ? GL_DEPTH32F_STENCIL8 : GL_DEPTH_COMPONENT32F;
  }
  if (this->hasStencil)
  {
    return GL_DEPTH24_STENCIL8;
  }
  return this->depthBits <= 16 ? GL_DEPTH_COMPONENT16
                               : (this->depthBits <= 24 ? GL_DEPTH_COMPONENT24 : GL_DEPTH_COMPONENT32);
}

FirstDrawBufferScope::FirstDrawBufferScope()
{
  GLint possible = 0;
  glGetIntegerv(GL_MAX_DRAW_BUFFERS, &possible);
  for (int i = 0; i < std::min(possible, most); ++i)
  {
    GLint buffer = GL_NONE;
    glGetIntegerv(static_cast<GLenum>(GL_DRAW_BUFFER0 + i), &buffer);
    this->buffers[i] = static_cast<unsigned int>(buffer);
    this->count = buffer != GL_NONE ? i + 1 : this->count;
  }
  if (this->count > 1)
  {
    glDrawBuffers(1, this->buffers);
  }
}

FirstDrawBufferScope::~FirstDrawBufferScope()
{
  if (this->count > 1)
  {
    glDrawBuffers(this->count, this->buffers);
  }
}

} // namespace shadow
