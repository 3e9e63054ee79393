#include "ShadowTarget.h"

#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include "OpenGL.h"
#include "ShadowPrograms.h"
#include "TargetTexture.h"

namespace shadow
{

unsigned int ShadowTarget::getTextureTarget() const
{
  return textureTargetOf(this->samples);
}

unsigned int ShadowTarget::makeTexture(unsigned int internalFormat, unsigned int format,
                                       unsigned int type) const
{
  return makeTargetTexture(this->width, this->height, this->samples, internalFormat, format, type);
}

unsigned int ShadowTarget::makeMask(int samplesOfMask) const
{
  return makeTargetTexture(this->width, this->height, samplesOfMask, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT);
}

bool ShadowTarget::allocate(vtkOpenGLState* state, int newWidth, int newHeight, int newSamples,
                            CountBuffer newBuffer, std::string& error)
{
  if (this->framebuffer != 0 && newWidth == this->width && newHeight == this->height &&
      newSamples == this->samplesAskedFor && newBuffer == this->buffer)
  {
    return true;
  }
  this->release();
  this->width = newWidth;
  this->height = newHeight;
  this->samples = this->samplesAskedFor = newSamples;
  this->buffer = newBuffer;
  const bool stencil = newBuffer == CountBuffer::Stencil;
  this->maskTexture = this->makeMask(newSamples);
  this->depthTexture =
      stencil ? this->makeTexture(GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV)
              : this->makeTexture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT);
  this->countTexture = stencil ? 0 : this->makeTexture(GL_R32F, GL_RED, GL_FLOAT);
  if (newSamples > 1)
  {
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, this->maskTexture);
    glGetTexLevelParameteriv(GL_TEXTURE_2D_MULTISAMPLE, 0, GL_TEXTURE_SAMPLES, &this->samples);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
  }
  glGenVertexArrays(1, &this->emptyVertexArray);
  this->framebuffer = this->makeFramebuffer(state, this->maskTexture);
  this->countFramebuffer = stencil ? this->framebuffer : this->makeFramebuffer(state, this->countTexture);
  if (this->framebuffer == 0 || this->countFramebuffer == 0)
  {
    this->release();
    error = "the GL refuses a shadow target of " + std::to_string(newWidth) + " x " +
            std::to_string(newHeight) + " pixels with " + std::to_string(newSamples) + " samples";
    return false;
  }
  this->findSamplePlaces(state);
  return true;
}

void ShadowTarget::findSamplePlaces(vtkOpenGLState* state)
{
  this->samplePlaces.assign(2 * static_cast<std::size_t>(this->samples), 0.5f);
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->framebuffer);
  for (int i = 0; i < this->samples && this->samples > 1; ++i)
  {
    glGetMultisamplefv(GL_SAMPLE_POSITION, static_cast<GLuint>(i),
                       &this->samplePlaces[2 * static_cast<std::size_t>(i)]);
  }
}

// 0 when the GL refuses.
unsigned int ShadowTarget::makeFramebuffer(vtkOpenGLState* state, unsigned int colorTexture) const
{
  const GLenum depthAttachment =
      this->buffer == CountBuffer::Stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT;
  GLuint made = 0;
  glGenFramebuffers(1, &made);
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, made);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, this->getTextureTarget(), colorTexture, 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, depthAttachment, this->getTextureTarget(), this->depthTexture, 0);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
  {
    glDeleteFramebuffers(1, &made);
    made = 0;
  }
  return made;
}

void ShadowTarget::begin(vtkOpenGLState* state, bool reversedDepth)
{
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->framebuffer);
  const GLenum drawBuffer = GL_COLOR_ATTACHMENT0;
  glDrawBuffers(1, &drawBuffer);
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
  const float farthest = reversedDepth ? 0.0f : 1.0f;
  if (this->buffer == CountBuffer::Stencil)
  {
    glClearBufferfi(GL_DEPTH_STENCIL, 0, farthest, 0);
  }
  else
  {
    glClearBufferfv(GL_DEPTH, 0, &farthest);
  }
}

void ShadowTarget::beginCount(vtkOpenGLState* state, const ScreenRectangle& counted)
{
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(counted.lower.x, counted.lower.y, counted.upper.x - counted.lower.x,
                      counted.upper.y - counted.lower.y);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  if (this->buffer == CountBuffer::Stencil)
  {
    state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    state->vtkglEnable(GL_STENCIL_TEST);
    state->vtkglStencilFuncSeparate(GL_FRONT_AND_BACK, GL_ALWAYS, 0, 0xff);
    return;
  }
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->countFramebuffer);
  const GLenum drawBuffer = GL_COLOR_ATTACHMENT0;
  glDrawBuffers(1, &drawBuffer);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const float nothing[4] = {0.0f, 0.0f, 0.0f, 0.0f};
  glClearBufferfv(GL_COLOR, 0, nothing);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglBlendFunc(GL_ONE, GL_ONE);
}

bool ShadowTarget::foldCount(vtkOpenGLState* state, ShadowPrograms& programs, int light, bool reversedDepth)
{
  const bool stencil = this->buffer == CountBuffer::Stencil;
  const ShadowPrograms::Stage stage =
      stencil ? ShadowPrograms::MaskFromStencil
              : (this->samples > 1 ? ShadowPrograms::MaskFromSamples : ShadowPrograms::MaskFromColor);
  vtkShaderProgram* program = programs.use(stage, false);
  if (program == nullptr)
  {
    return false;
  }
  program->SetUniformi("maskBit", light);
  if (stencil)
  {
    state->vtkglEnable(GL_STENCIL_TEST);
    state->vtkglStencilFuncSeparate(GL_FRONT_AND_BACK, GL_NOTEQUAL, 0, 0xff);
    state->vtkglStencilOpSeparate(GL_FRONT_AND_BACK, GL_ZERO, GL_ZERO, GL_ZERO);
  }
  this->combineWithMask(state, program, this->countTexture, "counts", reversedDepth);
  state->vtkglDisable(GL_SCISSOR_TEST);
  return true;
}

void ShadowTarget::combineWithMask(vtkOpenGLState* state, vtkShaderProgram* program, unsigned int texture,
                                   const char* sampler, bool reversedDepth) const
{
  // Drawn at the farthest depth, and seen where a surface is in front of it.
  program->SetUniformf("farDepth", reversedDepth ? 0.0f : 1.0f);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDepthFunc(reversedDepth ? GL_LESS : GL_GREATER);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->framebuffer);
  glEnable(GL_COLOR_LOGIC_OP);
  glLogicOp(GL_AND);
  if (texture != 0)
  {
    this->drawReading(state, texture, program, sampler);
  }
  else
  {
    this->drawScreen();
  }
  glDisable(GL_COLOR_LOGIC_OP);
}

bool ShadowTarget::drawWhereCleared(vtkOpenGLState* state, ShadowPrograms& programs, std::uint32_t bit)
{
  vtkShaderProgram* program = programs.use(ShadowPrograms::BackSeen, false);
  if (program == nullptr)
  {
    return false;
  }
  program->SetUniformi("backBit", static_cast<int>(bit));
  program->SetUniformf("farDepth", 0.0f);
  // Another buffer than the one that is read.
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->countFramebuffer);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  this->drawReading(state, this->maskTexture, program, "shadowMask");
  return true;
}

// Draws the whole target with a program that reads a texture.
void ShadowTarget::drawReading(vtkOpenGLState* state, unsigned int texture, vtkShaderProgram* program,
                               const char* sampler) const
{
  state->vtkglActiveTexture(GL_TEXTURE0);
  GLint before = 0;
  glGetIntegerv(this->samples > 1 ? GL_TEXTURE_BINDING_2D_MULTISAMPLE : GL_TEXTURE_BINDING_2D, &before);
  glBindTexture(this->getTextureTarget(), texture);
  program->SetUniformi(sampler, 0);
  this->drawScreen();
  glBindTexture(this->getTextureTarget(), static_cast<GLuint>(before));
}

void ShadowTarget::drawScreen() const
{
  glBindVertexArray(this->emptyVertexArray);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
}

void ShadowTarget::release(bool contextLost)
{
  if (!contextLost && this->maskTexture != 0)
  {
    glDeleteFramebuffers(1, &this->framebuffer);
    if (this->countFramebuffer != this->framebuffer)
    {
      glDeleteFramebuffers(1, &this->countFramebuffer);
    }
    glDeleteTextures(1, &this->maskTexture);
    glDeleteTextures(1, &this->maskBefore);
    glDeleteTextures(1, &this->depthTexture);
    glDeleteTextures(1, &this->countTexture);
    glDeleteVertexArrays(1, &this->emptyVertexArray);
  }
  this->framebuffer = this->countFramebuffer = this->emptyVertexArray = 0;
  this->maskTexture = this->maskBefore = this->depthTexture = this->countTexture = 0;
  this->width = this->height = this->samples = this->samplesAskedFor = 0;
}

std::size_t ShadowTarget::getMemorySize() const
{
  // 4 bytes a mask; 8 bytes depth and stencil, or 4 bytes depth and 4 bytes count
  const std::size_t bytes = this->maskBefore != 0 ? 16 : 12;
  return bytes * static_cast<std::size_t>(this->width) * static_cast<std::size_t>(this->height) *
         static_cast<std::size_t>(this->samples);
}

} // namespace shadow
