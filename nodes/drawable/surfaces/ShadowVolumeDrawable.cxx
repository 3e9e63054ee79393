#include "ShadowVolumeDrawable.h"

#include <vtkShaderProgram.h>

#include "OpenGL.h"
#include "ShadowPrograms.h"
#include "VertexLayout.h"

namespace shadow
{

void ShadowVolumeDrawable::upload(const ShadowVolume& volume)
{
  if (this->vertexArray == 0)
  {
    glGenVertexArrays(1, &this->vertexArray);
    glGenBuffers(1, &this->indexBuffer);
  }
  this->sides = volume.sides.size();
  this->doubledSides = volume.doubledSides.size();
  this->caps = volume.lightCap.size() + volume.darkCap.size();
  this->doubledCaps = volume.doubledDarkCap.size();
  this->reversedCaps = volume.lightCapReversed.size();
  this->bytes = volume.getTriangleCount() * sizeof(ShadowVolume::Triangle);

  glBindVertexArray(this->vertexArray);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, this->indexBuffer);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(this->bytes), nullptr, GL_STREAM_DRAW);
  GLintptr offset = 0;
  for (const auto* faces : {&volume.sides, &volume.doubledSides, &volume.lightCap, &volume.darkCap,
                            &volume.doubledDarkCap, &volume.lightCapReversed})
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

void ShadowVolumeDrawable::draw(const FaceCounter& counter, unsigned int vertexBuffer)
{
  vtkShaderProgram* program = counter.getProgram();
  glBindVertexArray(this->vertexArray);
  bindFloats(program, "vertexMC", vertexBuffer, 4);
  std::size_t first = 0;
  const auto count = [&](std::size_t triangles, int multiplicity, bool inward)
  {
    if (triangles > 0)
    {
      counter.count(multiplicity, inward, [&] { drawTriangles(first, triangles); });
    }
    first += triangles;
  };
  setDepthBias(program, counter.isDepthReversed(), true);
  count(this->sides, 1, false);
  count(this->doubledSides, 2, false);
  setDepthBias(program, counter.isDepthReversed(), false);
  count(this->caps, 1, false);
  count(this->doubledCaps, 2, false);
  count(this->reversedCaps, 1, true);
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
