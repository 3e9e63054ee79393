#include <algorithm>

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include "GLStateScope.h"
#include "OpenGL.h"
#include "ShadowPrograms.h"
#include "ShadowTarget.h"

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

std::vector<unsigned char> ShadowTarget::readMask(vtkOpenGLRenderWindow* window, int light)
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

void ShadowTarget::readResolved(vtkOpenGLRenderWindow* window, int light, std::vector<unsigned char>& mask)
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
    program->SetUniformi("maskBit", light);
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

} // namespace shadow
