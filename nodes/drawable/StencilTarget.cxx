#include "StencilTarget.h"

#include <algorithm>

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include "GLStateScope.h"
#include "OpenGL.h"
#include "ShadowPrograms.h"

namespace shadow
{

namespace
{

// Rows without gaps; leaves the packing as it was.
void readPixels(vtkOpenGLState* state, int width, int height, GLenum format, GLenum type, void* pixels)
{
  GLint alignment = 4;
  glGetIntegerv(GL_PACK_ALIGNMENT, &alignment);
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, format, type, pixels);
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, alignment);
}

} // namespace

unsigned int StencilTarget::getTextureTarget() const
{
  return this->samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
}

unsigned int StencilTarget::makeTexture(unsigned int internalFormat, unsigned int format,
                                        unsigned int type) const
{
  const GLenum target = this->getTextureTarget();
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(target, texture);
  if (this->samples > 1)
  {
    glTexImage2DMultisample(target, this->samples, internalFormat, this->width, this->height, GL_TRUE);
  }
  else
  {
    glTexImage2D(target, 0, static_cast<GLint>(internalFormat), this->width, this->height, 0, format, type,
                 nullptr);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
  }
  glBindTexture(target, 0);
  return texture;
}

bool StencilTarget::allocate(vtkOpenGLState* state, int newWidth, int newHeight, int newSamples,
                             std::string& error)
{
  if (this->framebuffer != 0 && newWidth == this->width && newHeight == this->height &&
      newSamples == this->samplesAskedFor)
  {
    return true;
  }
  this->release();
  this->width = newWidth;
  this->height = newHeight;
  this->samples = this->samplesAskedFor = newSamples;
  this->maskTexture = this->makeTexture(GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT);
  this->depthTexture =
      this->makeTexture(GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV);
  if (newSamples > 1)
  {
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, this->maskTexture);
    glGetTexLevelParameteriv(GL_TEXTURE_2D_MULTISAMPLE, 0, GL_TEXTURE_SAMPLES, &this->samples);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
  }
  glGenVertexArrays(1, &this->emptyVertexArray);
  glGenFramebuffers(1, &this->framebuffer);
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, this->getTextureTarget(), this->maskTexture,
                         0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, this->getTextureTarget(),
                         this->depthTexture, 0);
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE)
  {
    this->release();
    error = "the GL refuses a stencil target of " + std::to_string(newWidth) + " x " +
            std::to_string(newHeight) + " pixels with " + std::to_string(newSamples) + " samples";
    return false;
  }
  return true;
}

void StencilTarget::begin(vtkOpenGLState* state, bool reversedDepth)
{
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->framebuffer);
  const GLenum buffer = GL_COLOR_ATTACHMENT0;
  glDrawBuffers(1, &buffer);
  state->vtkglViewport(0, 0, this->width, this->height);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_BLEND);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglStencilMaskSeparate(GL_FRONT_AND_BACK, 0xff);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  const GLuint reached[4] = {0xffffffffu, 0, 0, 0};
  glClearBufferuiv(GL_COLOR, 0, reached);
  glClearBufferfi(GL_DEPTH_STENCIL, 0, reversedDepth ? 0.0f : 1.0f, 0);
}

bool StencilTarget::foldStencil(vtkOpenGLState* state, ShadowPrograms& programs, int light,
                                bool reversedDepth)
{
  vtkShaderProgram* program = programs.use(ShadowPrograms::Mask, false);
  if (program == nullptr)
  {
    return false;
  }
  program->SetUniformi("lightBit", light);
  // Drawn at the farthest depth, and seen where a surface is in front of it.
  program->SetUniformf("farDepth", reversedDepth ? 0.0f : 1.0f);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDepthFunc(reversedDepth ? GL_LESS : GL_GREATER);
  state->vtkglEnable(GL_STENCIL_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglStencilFuncSeparate(GL_FRONT_AND_BACK, GL_NOTEQUAL, 0, 0xff);
  state->vtkglStencilOpSeparate(GL_FRONT_AND_BACK, GL_ZERO, GL_ZERO, GL_ZERO);
  glEnable(GL_COLOR_LOGIC_OP);
  glLogicOp(GL_AND);
  glBindVertexArray(this->emptyVertexArray);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
  glDisable(GL_COLOR_LOGIC_OP);
  return true;
}

std::vector<unsigned char> StencilTarget::readMask(vtkOpenGLRenderWindow* window, int light)
{
  const std::size_t pixels = static_cast<std::size_t>(this->width) * static_cast<std::size_t>(this->height);
  std::vector<unsigned char> mask(pixels, 255);
  if (this->framebuffer == 0)
  {
    return mask;
  }
  if (this->samples > 1)
  {
    this->readResolved(window, light, mask);
    return mask;
  }
  std::vector<GLuint> words(pixels);
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, this->framebuffer);
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  readPixels(state, this->width, this->height, GL_RED_INTEGER, GL_UNSIGNED_INT, words.data());
  state->PopFramebufferBindings();
  std::transform(words.begin(), words.end(), mask.begin(),
                 [light](GLuint word) { return static_cast<unsigned char>((word >> light) & 1u ? 255 : 0); });
  return mask;
}

void StencilTarget::readResolved(vtkOpenGLRenderWindow* window, int light, std::vector<unsigned char>& mask)
{
  // The clip volume does not matter here, and is not changed.
  const GLStateScope scope(window->GetState(), false);
  GLuint share = 0;
  GLuint resolveBuffer = 0;
  glGenRenderbuffers(1, &share);
  glBindRenderbuffer(GL_RENDERBUFFER, share);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_R8, this->width, this->height);
  glGenFramebuffers(1, &resolveBuffer);
  window->GetState()->vtkglBindFramebuffer(GL_FRAMEBUFFER, resolveBuffer);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, share);
  vtkShaderProgram* program = ShadowPrograms(window).use(ShadowPrograms::Resolve, false);
  if (program != nullptr && glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE)
  {
    vtkOpenGLState* state = window->GetState();
    state->vtkglViewport(0, 0, this->width, this->height);
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglDisable(GL_STENCIL_TEST);
    state->vtkglDisable(GL_BLEND);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->vtkglActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, this->maskTexture);
    program->SetUniformf("farDepth", 0.0f);
    program->SetUniformi("shadowMask", 0);
    program->SetUniformi("lightBit", light);
    program->SetUniformi("samples", this->samples);
    glBindVertexArray(this->emptyVertexArray);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    readPixels(state, this->width, this->height, GL_RED, GL_UNSIGNED_BYTE, mask.data());
  }
  glDeleteFramebuffers(1, &resolveBuffer);
  glDeleteRenderbuffers(1, &share);
}

void StencilTarget::release(bool contextLost)
{
  if (!contextLost && this->maskTexture != 0)
  {
    glDeleteFramebuffers(1, &this->framebuffer);
    glDeleteTextures(1, &this->maskTexture);
    glDeleteTextures(1, &this->depthTexture);
    glDeleteVertexArrays(1, &this->emptyVertexArray);
  }
  this->framebuffer = this->maskTexture = this->depthTexture = this->emptyVertexArray = 0;
  this->width = this->height = this->samples = this->samplesAskedFor = 0;
}

std::size_t StencilTarget::getMemorySize() const
{
  // 4 bytes mask, 8 bytes depth and stencil
  return std::size_t{12} * static_cast<std::size_t>(this->width) * static_cast<std::size_t>(this->height) *
         static_cast<std::size_t>(this->samples);
}

} // namespace shadow
