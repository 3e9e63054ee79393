#include "SEDGeometryDrawable.h"

#include <algorithm>

#include <vtkShaderProgram.h>

#include "OpenGL.h"
#include "VertexLayout.h"

namespace shadow
{

namespace
{

std::vector<glm::vec4> nearAndFarCopies(const std::vector<glm::vec3>& positions)
{
  std::vector<glm::vec4> vertices;
  vertices.reserve(2 * positions.size());
  for (const glm::vec3& position : positions)
  {
    vertices.emplace_back(position, 1.0f);
    vertices.emplace_back(position, 0.0f);
  }
  return vertices;
}

std::vector<std::uint32_t> nearIndices(const std::vector<std::array<std::uint32_t, 3>>& triangles)
{
  std::vector<std::uint32_t> indices;
  indices.reserve(3 * triangles.size());
  for (const auto& triangle : triangles)
  {
    for (const std::uint32_t vertex : triangle)
    {
      indices.push_back(2 * vertex);
    }
  }
  return indices;
}

} // namespace

SEDGeometryDrawable::SEDGeometryDrawable(const SEDGeometry& geometry)
{
  const std::vector<glm::vec4> vertices = nearAndFarCopies(geometry.getPositions());
  const std::vector<std::uint32_t> indices = nearIndices(geometry.getTriangles());
  const std::size_t vertexBytes = vertices.size() * sizeof(glm::vec4);
  const std::size_t indexBytes = indices.size() * sizeof(std::uint32_t);
  this->bytes = vertexBytes + indexBytes;

  glGenVertexArrays(1, &this->vertexArray);
  glBindVertexArray(this->vertexArray);
  glGenBuffers(1, &this->vertexBuffer);
  glBindBuffer(GL_ARRAY_BUFFER, this->vertexBuffer);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertexBytes), vertices.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glGenBuffers(1, &this->indexBuffer);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, this->indexBuffer);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indexBytes), indices.data(), GL_STATIC_DRAW);
  glBindVertexArray(0);
}

void SEDGeometryDrawable::draw(vtkShaderProgram* program, std::size_t first, std::size_t count)
{
  glBindVertexArray(this->vertexArray);
  bindVertices(program, this->vertexBuffer);
  drawTriangles(first, count);
  glBindVertexArray(0);
}

void SEDGeometryDrawable::release(bool contextLost)
{
  if (!contextLost)
  {
    glDeleteVertexArrays(1, &this->vertexArray);
    glDeleteBuffers(1, &this->vertexBuffer);
    glDeleteBuffers(1, &this->indexBuffer);
  }
  this->vertexArray = this->vertexBuffer = this->indexBuffer = 0;
}

void ReachableBitsTexture::upload(const std::vector<glm::uvec2>& bits, std::size_t maximumTexels)
{
  const std::size_t needed = std::max<std::size_t>(1, (bits.size() + maximumTexels - 1) / maximumTexels);
  if (needed != this->parts.size())
  {
    this->release(false);
    this->parts.resize(needed);
    for (Part& part : this->parts)
    {
      glGenBuffers(1, &part.buffer);
      glGenTextures(1, &part.texture);
    }
  }
  std::size_t first = 0;
  for (Part& part : this->parts)
  {
    part.first = first;
    part.count = std::min(maximumTexels, bits.size() - first);
    first += part.count;
    glBindBuffer(GL_TEXTURE_BUFFER, part.buffer);
    glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(part.count * sizeof(glm::uvec2)),
                 bits.data() + part.first, GL_STREAM_DRAW);
    glBindTexture(GL_TEXTURE_BUFFER, part.texture);
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RG32UI, part.buffer);
  }
  glBindTexture(GL_TEXTURE_BUFFER, 0);
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
}

void ReachableBitsTexture::release(bool contextLost)
{
  for (Part& part : this->parts)
  {
    if (!contextLost)
    {
      glDeleteTextures(1, &part.texture);
      glDeleteBuffers(1, &part.buffer);
    }
  }
  this->parts.clear();
  this->revision = 0;
}

std::size_t ReachableBitsTexture::getMemorySize() const
{
  std::size_t texels = 0;
  for (const Part& part : this->parts)
  {
    texels += part.count;
  }
  return texels * sizeof(glm::uvec2);
}

} // namespace shadow
