#include "ShadowVolumeDrawable.h"

#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include "OpenGL.h"
#include "VertexLayout.h"

namespace shadow
{

namespace
{

// Faces whose outside is seen are entered, the others left, as the eye looks along the ray.
void setStencilOperations(vtkOpenGLState* state, StencilCount count, bool outsideIsFrontFace)
{
  const GLenum outside = outsideIsFrontFace ? GL_FRONT : GL_BACK;
  const GLenum inside = outsideIsFrontFace ? GL_BACK : GL_FRONT;
  if (count == StencilCount::ZPass)
  {
    state->vtkglStencilOpSeparate(outside, GL_KEEP, GL_KEEP, GL_INCR_WRAP);
    state->vtkglStencilOpSeparate(inside, GL_KEEP, GL_KEEP, GL_DECR_WRAP);
  }
  else
  {
    state->vtkglStencilOpSeparate(outside, GL_KEEP, GL_DECR_WRAP, GL_KEEP);
    state->vtkglStencilOpSeparate(inside, GL_KEEP, GL_INCR_WRAP, GL_KEEP);
  }
}

} // namespace

void ShadowVolumeDrawable::upload(const ShadowVolume& volume)
{
  if (this->vertexArray == 0)
  {
    glGenVertexArrays(1, &this->vertexArray);
    glGenBuffers(1, &this->indexBuffer);
  }
  this->sideTriangles = volume.sides.size();
  this->outwardTriangles = volume.lightCap.size() + volume.darkCap.size();
  this->inwardTriangles = volume.lightCapReversed.size();
  this->bytes = volume.getTriangleCount() * sizeof(ShadowVolume::Triangle);

  glBindVertexArray(this->vertexArray);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, this->indexBuffer);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(this->bytes), nullptr, GL_STREAM_DRAW);
  GLintptr offset = 0;
  for (const auto* faces : {&volume.sides, &volume.lightCap, &volume.darkCap, &volume.lightCapReversed})
  {
    const auto size = static_cast<GLsizeiptr>(faces->size() * sizeof(ShadowVolume::Triangle));
    if (size > 0)
    {
      glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, offset, size, faces->data());
    }
    offset += size;
  }
  glBindVertexArray(0);
}

void ShadowVolumeDrawable::draw(vtkOpenGLState* state, vtkShaderProgram* program, unsigned int vertexBuffer,
                                StencilCount count, bool reversedDepth, bool mirrored)
{
  glBindVertexArray(this->vertexArray);
  bindFloats(program, "vertexMC", vertexBuffer, 4);
  setStencilOperations(state, count, !mirrored);
  if (this->sideTriangles > 0)
  {
    // Relative to the distance, and so the same number of units everywhere.
    constexpr float rounding = 1.2e-7f; // two units in the last place
    const float bias[2] = {1.0f - rounding, reversedDepth ? 0.0f : rounding};
    program->SetUniform2f("depthBias", bias);
    drawTriangles(0, this->sideTriangles);
  }
  const float unbiased[2] = {1.0f, 0.0f};
  program->SetUniform2f("depthBias", unbiased);
  if (this->outwardTriangles > 0)
  {
    drawTriangles(this->sideTriangles, this->outwardTriangles);
  }
  if (this->inwardTriangles > 0)
  {
    setStencilOperations(state, count, mirrored);
    drawTriangles(this->sideTriangles + this->outwardTriangles, this->inwardTriangles);
  }
  glBindVertexArray(0);
}

void ShadowVolumeDrawable::release(bool contextLost)
{
  if (!contextLost)
  {
    glDeleteVertexArrays(1, &this->vertexArray);
    glDeleteBuffers(1, &this->indexBuffer);
  }
  this->vertexArray = this->indexBuffer = 0;
  this->revision = 0;
}

} // namespace shadow
