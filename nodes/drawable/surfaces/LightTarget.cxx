#include "LightTarget.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include "GLStateScope.h"
#include "OpenGL.h"
#include "ShadowPrograms.h"
#include "TargetTexture.h"

namespace shadow
{

bool LightTarget::allocate(int newWidth, int newHeight, int newSamples)
{
  if (this->texture != 0 && newWidth == this->width && newHeight == this->height &&
      newSamples == this->samples)
  {
    return true;
  }
  this->release();
  this->width = newWidth;
  this->height = newHeight;
  this->samples = newSamples;
  this->texture = makeTargetTexture(newWidth, newHeight, newSamples, GL_RGBA16F, GL_RGBA, GL_FLOAT);
  glGenVertexArrays(1, &this->emptyVertexArray);
  glGenFramebuffers(1, &this->framebuffer);
  return this->texture != 0 && this->framebuffer != 0;
}

bool LightTarget::begin(vtkOpenGLState* state, std::string& error)
{
  this->caller = CallerFramebuffer::query();
  if (!this->caller.canShareDepth() || this->caller.hasMoreColours)
  {
    error = "lights cannot be added one by one here: the framebuffer has no depth that can be shared, or more "
            "than one colour buffer";
    return false;
  }
  int viewport[4] = {0, 0, 0, 0};
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  bool complete = this->allocate(viewport[0] + viewport[2], viewport[1] + viewport[3], this->caller.samples);
  if (complete)
  {
    state->PushFramebufferBindings();
    state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->framebuffer);
    glFramebufferTexture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, this->texture, 0);
    this->caller.attachDepth();
    const GLenum drawBuffer = GL_COLOR_ATTACHMENT0;
    glDrawBuffers(1, &drawBuffer);
    complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    state->PopFramebufferBindings();
  }
  if (!complete)
  {
    glGetError(); // which says no more than this line
    error = "lights cannot be added one by one: the GL refuses a colour buffer for them of " +
            std::to_string(this->width) + " x " + std::to_string(this->height) + " pixels with " +
            std::to_string(this->samples) + " samples";
    this->release();
  }
  return complete;
}

void LightTarget::beginLight(vtkOpenGLState* state)
{
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->framebuffer);
  const float nothing[4] = {0.0f, 0.0f, 0.0f, 0.0f};
  glClearBufferfv(GL_COLOR, 0, nothing);
}

bool LightTarget::addLight(vtkOpenGLRenderWindow* window, bool hasClipControl)
{
  vtkOpenGLState* state = window->GetState();
  state->PopFramebufferBindings();
  const GLStateScope scope(state, hasClipControl);
  const FirstDrawBufferScope drawBuffer;
  const bool multisampled = this->samples > 1;
  vtkShaderProgram* program = ShadowPrograms(window).use(
      ShadowPrograms::AddLight, false, multisampled ? "#define SHADOW_MULTISAMPLE\n" : "");
  if (program == nullptr)
  {
    return false;
  }
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_STENCIL_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  const vtkOpenGLState::ScopedglEnableDisable multisampling(state, GL_MULTISAMPLE);
  state->vtkglActiveTexture(GL_TEXTURE0);
  glBindTexture(textureTargetOf(this->samples), this->texture);
  program->SetUniformi("light", 0);
  program->SetUniformf("farDepth", 0.0f);
  glBindVertexArray(this->emptyVertexArray);
  if (multisampled)
  {
    // One sample after the other, as GL 3.2 can.
    state->vtkglEnable(GL_MULTISAMPLE);
    glEnable(GL_SAMPLE_MASK);
    for (int i = 0; i < this->samples; ++i)
    {
      program->SetUniformi("sampleIndex", i);
      glSampleMaski(0, 1u << i);
      glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    glSampleMaski(0, 0xffffffffu);
    glDisable(GL_SAMPLE_MASK);
  }
  else
  {
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  return true;
}

void LightTarget::end(vtkOpenGLState* state)
{
  // What is attached to a framebuffer is not freed when its owner frees it.
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->framebuffer);
  glFramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, 0, 0);
  state->PopFramebufferBindings();
}

void LightTarget::release(bool contextLost)
{
  if (!contextLost && this->texture != 0)
  {
    glDeleteFramebuffers(1, &this->framebuffer);
    glDeleteTextures(1, &this->texture);
    glDeleteVertexArrays(1, &this->emptyVertexArray);
  }
  this->framebuffer = this->texture = this->emptyVertexArray = 0;
  this->width = this->height = this->samples = 0;
}

std::size_t LightTarget::getMemorySize() const
{
  // 8 bytes a sample
  return std::size_t{8} * static_cast<std::size_t>(this->width) * static_cast<std::size_t>(this->height) *
         static_cast<std::size_t>(this->samples);
}

} // namespace shadow
