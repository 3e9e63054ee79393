#include "OutlineTarget.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include "CallerFramebuffer.h"
#include "OpenGL.h"
#include "PixelTransferScope.h"
#include "SEDGeometryDrawable.h"
#include "TargetTexture.h"

namespace shadow
{

namespace
{

constexpr int depthUnit = 0;
constexpr int slopeUnit = 1;
constexpr int windowUnit = SEDGeometryDrawable::firstFreeUnit + 1; // after what finds lines

void bindTexture(vtkOpenGLState* state, int unit, unsigned int texture)
{
  state->vtkglActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_2D, texture);
}

// 0 when the GL refuses.
unsigned int makeFramebuffer(vtkOpenGLState* state, unsigned int colorTexture, unsigned int depthTexture,
                             unsigned int secondTexture = 0)
{
  GLuint made = 0;
  glGenFramebuffers(1, &made);
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, made);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colorTexture, 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, secondTexture, 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depthTexture, 0);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
  {
    glDeleteFramebuffers(1, &made);
    made = 0;
  }
  return made;
}

} // namespace

unsigned int OutlineTarget::makeTexture(int scale, unsigned int internalFormat, unsigned int format,
                                        unsigned int type) const
{
  return makeTargetTexture(scale * this->width, scale * this->height, 1, internalFormat, format, type);
}

bool OutlineTarget::allocate(vtkOpenGLState* state, int newWidth, int newHeight, int newDepthScale,
                             bool keepsDepth, std::string& error)
{
  if (this->depthFramebuffer != 0 && newWidth == this->width && newHeight == this->height &&
      newDepthScale == this->depthScale && keepsDepth == (this->nearnessTexture != 0))
  {
    return true;
  }
  this->release();
  this->width = newWidth;
  this->height = newHeight;
  this->depthScale = newDepthScale;
  this->depthTexture = this->makeTexture(newDepthScale, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT);
  this->slopeTexture = this->makeTexture(newDepthScale, GL_RG16F, GL_RG, GL_FLOAT);
  this->lineTexture = this->makeTexture(1, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
  this->nearnessTexture = keepsDepth ? this->makeTexture(1, GL_R32F, GL_RED, GL_FLOAT) : 0;
  glGenVertexArrays(1, &this->emptyVertexArray);
  this->depthFramebuffer = makeFramebuffer(state, this->slopeTexture, this->depthTexture);
  this->lineFramebuffer = makeFramebuffer(state, this->lineTexture, 0, this->nearnessTexture);
  if (this->depthFramebuffer == 0 || this->lineFramebuffer == 0)
  {
    this->release();
    error = "the GL refuses an outline target of " + std::to_string(newWidth) + " x " +
            std::to_string(newHeight) + " pixels";
    return false;
  }
  return true;
}

void OutlineTarget::setUp(vtkOpenGLState* state, unsigned int framebuffer, int scale) const
{
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  const GLenum drawBuffer = GL_COLOR_ATTACHMENT0;
  glDrawBuffers(1, &drawBuffer);
  state->vtkglViewport(0, 0, scale * this->width, scale * this->height);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_STENCIL_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDisable(GL_DEPTH_CLAMP);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

void OutlineTarget::beginDepth(vtkOpenGLState* state, bool reversedDepth)
{
  this->setUp(state, this->depthFramebuffer, this->depthScale);
  state->vtkglDisable(GL_BLEND);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(reversedDepth ? GL_GREATER : GL_LESS);
  const float farthest = reversedDepth ? 0.0f : 1.0f;
  glClearBufferfv(GL_DEPTH, 0, &farthest);
}

void OutlineTarget::beginLines(vtkOpenGLState* state, vtkShaderProgram* program, unsigned int windowDepth)
{
  this->setUp(state, this->lineFramebuffer, 1);
  const float nothing[4] = {0.0f, 0.0f, 0.0f, 0.0f};
  glClearBufferfv(GL_COLOR, 0, nothing);
  if (this->nearnessTexture != 0)
  {
    const GLenum both[2] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(2, both);
    glClearBufferfv(GL_COLOR, 1, nothing);
  }
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_MAX);
  bindTexture(state, depthUnit, this->depthTexture);
  bindTexture(state, slopeUnit, this->slopeTexture);
  if (windowDepth != 0)
  {
    bindTexture(state, windowUnit, windowDepth);
    program->SetUniformi("windowDepths", windowUnit);
  }
  program->SetUniformi("depths", depthUnit);
  program->SetUniformi("slopes", slopeUnit);
  program->SetUniformf("depthScale", static_cast<float>(this->depthScale));
  glBindVertexArray(this->emptyVertexArray);
}

void OutlineTarget::drawOver(vtkOpenGLState* state, vtkShaderProgram* program, int margin) const
{
  int viewport[4] = {0, 0, 0, 0};
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const int first[2] = {margin - viewport[0], margin - viewport[1]};
  state->vtkglDisable(GL_STENCIL_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  bindTexture(state, depthUnit, this->lineTexture);
  program->SetUniformi("coverages", depthUnit);
  program->SetUniform2i("firstPixel", first);
  program->SetUniformf("farDepth", 0.0f);
  glBindVertexArray(this->emptyVertexArray);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void OutlineTarget::blend(vtkOpenGLState* state, vtkShaderProgram* program, int margin)
{
  const FirstDrawBufferScope drawBuffer;
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  this->drawOver(state, program, margin);
}

void OutlineTarget::blendDepth(vtkOpenGLState* state, vtkShaderProgram* program, int margin)
{
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_LESS);
  bindTexture(state, slopeUnit, this->nearnessTexture);
  program->SetUniformi("nearnesses", slopeUnit);
  this->drawOver(state, program, margin);
}

std::vector<unsigned char> OutlineTarget::readMask(vtkOpenGLRenderWindow* window, int margin) const
{
  const int columns = this->width - 2 * margin;
  const int rows = this->height - 2 * margin;
  std::vector<unsigned char> mask(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  const PixelTransferScope transfer;
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, this->lineFramebuffer);
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  glReadPixels(margin, margin, columns, rows, GL_BLUE, GL_UNSIGNED_BYTE, mask.data());
  state->PopFramebufferBindings();
  return mask;
}

void OutlineTarget::release(bool contextLost)
{
  if (!contextLost && this->depthTexture != 0)
  {
    glDeleteFramebuffers(1, &this->depthFramebuffer);
    glDeleteFramebuffers(1, &this->lineFramebuffer);
    glDeleteTextures(1, &this->depthTexture);
    glDeleteTextures(1, &this->slopeTexture);
    glDeleteTextures(1, &this->lineTexture);
    glDeleteTextures(1, &this->nearnessTexture);
    glDeleteVertexArrays(1, &this->emptyVertexArray);
  }
  this->depthFramebuffer = this->lineFramebuffer = this->emptyVertexArray = 0;
  this->depthTexture = this->slopeTexture = this->lineTexture = this->nearnessTexture = 0;
  this->width = this->height = 0;
}

std::size_t OutlineTarget::getMemorySize() const
{
  // 4 bytes lines, 4 their depth; 4 bytes depth and 4 bytes slope
  const std::size_t pixels = static_cast<std::size_t>(this->width) * static_cast<std::size_t>(this->height);
  const std::size_t lines = this->nearnessTexture != 0 ? 8 : 4;
  return (lines + 8 * static_cast<std::size_t>(this->depthScale * this->depthScale)) * pixels;
}

} // namespace shadow
