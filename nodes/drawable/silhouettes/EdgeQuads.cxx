#include "EdgeQuads.h"

#include "BufferUpload.h"
#include "OpenGL.h"
#include "VertexLayout.h"

namespace shadow
{

namespace
{

void drawCommand(std::size_t offset)
{
  glDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT,
                         reinterpret_cast<const void*>(offset)); // NOLINT: GL takes offsets as pointers
}

} // namespace

// Binds the indices of at least as many edges.
void EdgeQuads::Part::bind(std::size_t edges)
{
  if (this->vertexArray == 0)
  {
    glGenVertexArrays(1, &this->vertexArray);
    glGenBuffers(1, &this->indexBuffer);
  }
  glBindVertexArray(this->vertexArray);
  if (edges <= this->capacity)
  {
    return;
  }
  this->capacity = edges;
  std::vector<std::uint32_t> indices;
  indices.reserve(this->corners.size() * edges);
  for (std::uint32_t first = 0; first < 5 * edges; first += 5)
  {
    for (const std::uint32_t corner : this->corners)
    {
      indices.push_back(first + corner);
    }
  }
  this->bytes = uploadBuffer(GL_ELEMENT_ARRAY_BUFFER, this->indexBuffer, indices, GL_STATIC_DRAW);
}

void EdgeQuads::Part::release(bool contextLost)
{
  if (!contextLost && this->vertexArray != 0)
  {
    glDeleteVertexArrays(1, &this->vertexArray);
    glDeleteBuffers(1, &this->indexBuffer);
  }
  this->vertexArray = this->indexBuffer = 0;
  this->capacity = this->bytes = 0;
}

void EdgeQuads::draw(std::size_t edges, bool withFan)
{
  this->quads.bind(edges);
  drawTriangles(0, 2 * edges);
  if (withFan)
  {
    this->fans.bind(edges);
    drawTriangles(0, edges);
  }
  glBindVertexArray(0);
}

void EdgeQuads::drawIndirect(unsigned int commands, std::size_t offset, std::size_t mostEdges, bool withFan)
{
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, commands);
  this->quads.bind(mostEdges);
  drawCommand(offset);
  if (withFan)
  {
    this->fans.bind(mostEdges);
    drawCommand(offset + sizeof(Command));
  }
  glBindVertexArray(0);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

void EdgeQuads::release(bool contextLost)
{
  this->quads.release(contextLost);
  this->fans.release(contextLost);
}

} // namespace shadow
