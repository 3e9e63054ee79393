#include "ShadowVolumeDrawable.h"

#include <vtkShaderProgram.h>

#include "BufferUpload.h"
#include "OpenGL.h"
#include "ShadowPrograms.h"
#include "VertexLayout.h"

namespace shadow
{

std::size_t ShadowVolumeDrawable::Indices::upload(const std::vector<Faces>& lists)
{
  if (this->vertexArray == 0)
  {
    glGenVertexArrays(1, &this->vertexArray);
    glGenBuffers(1, &this->indexBuffer);
  }
  this->batches.clear();
  std::size_t triangles = 0;
  for (const Faces& faces : lists)
  {
    this->batches.push_back({faces.triangles->size(), faces.kind});
    triangles += faces.triangles->size();
  }
  const std::size_t size = triangles * sizeof(ShadowVolume::Triangle);
  glBindVertexArray(this->vertexArray);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, this->indexBuffer);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(size), nullptr, GL_STREAM_DRAW);
  GLintptr offset = 0;
  for (const Faces& faces : lists)
  {
    const auto part = static_cast<GLsizeiptr>(faces.triangles->size() * sizeof(ShadowVolume::Triangle));
    if (part > 0)
    {
      glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, offset, part, faces.triangles->data());
    }
    offset += part;
  }
  glBindVertexArray(0);
  return size;
}

void ShadowVolumeDrawable::Indices::draw(const FaceCounter& counter, unsigned int vertexBuffer) const
{
  glBindVertexArray(this->vertexArray);
  bindFloats(counter.getProgram(), "vertexMC", vertexBuffer, 4);
  std::size_t first = 0;
  for (const Batch& batch : this->batches)
  {
    if (batch.triangles > 0)
    {
      setDepthBias(counter.getProgram(), counter.isDepthReversed(), batch.kind.side);
      counter.count(batch.kind.multiplicity, batch.kind.inward, [&] { drawTriangles(first, batch.triangles); });
    }
    first += batch.triangles;
  }
  glBindVertexArray(0);
}

void ShadowVolumeDrawable::Indices::release(bool contextLost)
{
  if (!contextLost)
  {
    glDeleteVertexArrays(1, &this->vertexArray);
    glDeleteBuffers(1, &this->indexBuffer);
  }
  this->vertexArray = this->indexBuffer = 0;
}

template <class Owner, std::size_t count>
std::vector<ShadowVolumeDrawable::Faces>
ShadowVolumeDrawable::listFaces(const Owner& owner, const std::array<FacesOf<Owner>, count>& kinds)
{
  std::vector<Faces> lists;
  for (const FacesOf<Owner>& faces : kinds)
  {
    lists.push_back({&(owner.*faces.triangles), faces.kind});
  }
  return lists;
}

void ShadowVolumeDrawable::upload(const ShadowVolume& volume)
{
  this->bytes = this->whole.upload(listFaces(volume, volumeFaces));
  if (volume.close.vertices.empty())
  {
    this->close.batches.clear();
    return;
  }
  this->bytes += this->close.upload(listFaces(volume.close, closeFaces));
  if (this->closeVertexBuffer == 0)
  {
    glGenBuffers(1, &this->closeVertexBuffer);
  }
  this->bytes +=
      uploadBuffer(GL_ARRAY_BUFFER, this->closeVertexBuffer, volume.close.vertices, GL_STREAM_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void ShadowVolumeDrawable::draw(const FaceCounter& counter, unsigned int vertexBuffer)
{
  this->whole.draw(counter, vertexBuffer);
  if (!this->close.batches.empty())
  {
    this->close.draw(counter, this->closeVertexBuffer);
  }
}

void ShadowVolumeDrawable::release(bool contextLost)
{
  this->whole.release(contextLost);
  this->close.release(contextLost);
  if (!contextLost)
  {
    glDeleteBuffers(1, &this->closeVertexBuffer);
  }
  this->closeVertexBuffer = 0;
  this->revision = 0;
}

} // namespace shadow
