#include "WindowDepth.h"

#include <vtkOpenGLState.h>

#include "CallerFramebuffer.h"
#include "OpenGL.h"
#include "TargetTexture.h"

namespace shadow
{

namespace
{

struct TransferFormat
{
  GLenum format;
  GLenum type;
};

TransferFormat transferFormatOf(GLenum internalFormat)
{
  switch (internalFormat)
  {
    case GL_DEPTH32F_STENCIL8:
      return {GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV};
    case GL_DEPTH24_STENCIL8:
      return {GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8};
    default:
      return {GL_DEPTH_COMPONENT, GL_FLOAT};
  }
}

} // namespace

bool WindowDepth::allocate(vtkOpenGLState* state, int newWidth, int newHeight, unsigned int newFormat)
{
  if (this->texture != 0 && newWidth == this->width && newHeight == this->height && newFormat == this->format)
  {
    return true;
  }
  this->release();
  this->width = newWidth;
  this->height = newHeight;
  this->format = newFormat;
  const TransferFormat transfer = transferFormatOf(newFormat);
  this->texture = makeTargetTexture(newWidth, newHeight, 1, newFormat, transfer.format, transfer.type);
  glGenFramebuffers(1, &this->framebuffer);
  state->PushDrawFramebufferBinding();
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->framebuffer);
  const bool stencil = transfer.format == GL_DEPTH_STENCIL;
  glFramebufferTexture(GL_DRAW_FRAMEBUFFER, stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
                       this->texture, 0);
  glDrawBuffer(GL_NONE);
  const bool complete = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  state->PopDrawFramebufferBinding();
  return complete;
}

bool WindowDepth::copy(vtkOpenGLState* state, std::string& error)
{
  const CallerFramebuffer caller = CallerFramebuffer::query();
  int viewport[4] = {0, 0, 0, 0};
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const int right = viewport[0] + viewport[2];
  const int top = viewport[1] + viewport[3];
  bool copied = caller.depthType != GL_NONE &&
                this->allocate(state, viewport[2], viewport[3], caller.depthFormat());
  if (copied)
  {
    glGetError(); // what has been there is none of the copy's
    state->PushFramebufferBindings();
    state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, caller.name);
    state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->framebuffer);
    state->vtkglDisable(GL_SCISSOR_TEST);
    glBlitFramebuffer(viewport[0], viewport[1], right, top, 0, 0, viewport[2], viewport[3],
                      GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    copied = glGetError() == GL_NO_ERROR;
    state->PopFramebufferBindings();
  }
  if (!copied)
  {
    this->release();
    error = "lines are not hidden by what the pass does not know: the GL does not give the window's depth";
  }
  return copied;
}

void WindowDepth::release(bool contextLost)
{
  if (!contextLost && this->texture != 0)
  {
    glDeleteFramebuffers(1, &this->framebuffer);
    glDeleteTextures(1, &this->texture);
  }
  this->framebuffer = this->texture = 0;
  this->width = this->height = 0;
}

std::size_t WindowDepth::getMemorySize() const
{
  // 4 bytes, 8 with a float beside the stencil
  return std::size_t{this->format == GL_DEPTH32F_STENCIL8 ? 8u : 4u} * static_cast<std::size_t>(this->width) *
         static_cast<std::size_t>(this->height);
}

} // namespace shadow
