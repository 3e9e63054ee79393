#include "TexelPainter.h"

#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include "OpenGL.h"
#include "TexelArray.h"

namespace shadow
{

namespace
{

/// One point, one texel, nothing but colour.
void setState(vtkOpenGLState* state)
{
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_STENCIL_TEST);
  state->vtkglDisable(GL_BLEND);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDisable(GL_COLOR_LOGIC_OP);
}

/// Points of one pixel while it stands. Behind vtkOpenGLState, which so never learns of the change.
class PointSizeScope
{
public:
  PointSizeScope()
  {
    glGetFloatv(GL_POINT_SIZE, &this->previous);
    glPointSize(1.0f);
  }
  ~PointSizeScope() { glPointSize(this->previous); }
  PointSizeScope(const PointSizeScope&) = delete;
  PointSizeScope& operator=(const PointSizeScope&) = delete;

private:
  float previous = 1.0f;
};

} // namespace

bool TexelPainter::paint(vtkOpenGLState* state, const TexelArray& texels, vtkShaderProgram* program,
                         const DrawPoints& drawPoints, std::string& error)
{
  if (this->framebuffer == 0)
  {
    glGenFramebuffers(1, &this->framebuffer);
  }
  const PointSizeScope pointSize;
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->framebuffer);
  const int layerSize[2] = {texels.getWidth(), texels.getHeight()};
  program->SetUniform2i("layerSize", layerSize);
  setState(state);
  state->vtkglViewport(0, 0, layerSize[0], layerSize[1]);
  bool complete = true;
  for (int layer = 0; complete && layer < texels.getLayers(); ++layer)
  {
    texels.attachLayer(GL_FRAMEBUFFER, layer);
    const GLenum buffer = GL_COLOR_ATTACHMENT0;
    glDrawBuffers(1, &buffer);
    complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    if (complete)
    {
      drawPoints(texels.getFirstOfLayer(layer), texels.getCountOfLayer(layer));
    }
  }
  // The texture may be freed before the framebuffer is.
  glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, 0, 0, 0);
  if (!complete)
  {
    error = "the GL cannot draw into a texture of " + std::to_string(texels.getChannels()) +
            " 32-bit integers a texel";
  }
  return complete;
}

bool TexelPainter::paint(vtkOpenGLState* state, const TexelArray& texels, vtkShaderProgram* program,
                         std::string& error)
{
  if (this->emptyVertexArray == 0)
  {
    glGenVertexArrays(1, &this->emptyVertexArray);
  }
  const auto drawNumbers = [&](std::size_t first, std::size_t count)
  {
    glBindVertexArray(this->emptyVertexArray);
    glDrawArrays(GL_POINTS, static_cast<GLint>(first), static_cast<GLsizei>(count));
    glBindVertexArray(0);
  };
  return this->paint(state, texels, program, drawNumbers, error);
}

void TexelPainter::release(bool contextLost)
{
  if (!contextLost && this->framebuffer != 0)
  {
    glDeleteFramebuffers(1, &this->framebuffer);
  }
  if (!contextLost && this->emptyVertexArray != 0)
  {
    glDeleteVertexArrays(1, &this->emptyVertexArray);
  }
  this->framebuffer = this->emptyVertexArray = 0;
}

} // namespace shadow
