#include "EdgeQuads.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "OpenGL.h"
#include "VertexLayout.h"

namespace shadow
{

void EdgeQuads::reserve(std::size_t edges)
{
  if (edges <= this->capacity)
  {
    return;
  }
  this->capacity = edges;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  triangles.reserve(3 * edges);
  for (std::uint32_t first = 0; first < 5 * edges; first += 5)
  {
    triangles.push_back({first, first + 1, first + 2});
    triangles.push_back({first, first + 2, first + 3});
  }
  for (std::uint32_t first = 0; first < 5 * edges; first += 5)
  {
    triangles.push_back({first + 4, first + 3, first + 2});
  }
  if (this->vertexArray == 0)
  {
    glGenVertexArrays(1, &this->vertexArray);
    glGenBuffers(1, &this->indexBuffer);
  }
  this->bytes = triangles.size() * sizeof(triangles[0]);
  glBindVertexArray(this->vertexArray);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, this->indexBuffer);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(this->bytes), triangles.data(),
               GL_STATIC_DRAW);
  glBindVertexArray(0);
}

void EdgeQuads::draw(std::size_t edges, bool withFan)
{
  this->reserve(edges);
  glBindVertexArray(this->vertexArray);
  drawTriangles(0, 2 * edges);
  if (withFan)
  {
    drawTriangles(2 * this->capacity, edges);
  }
  glBindVertexArray(0);
}

void EdgeQuads::release(bool contextLost)
{
  if (!contextLost)
  {
    glDeleteVertexArrays(1, &this->vertexArray);
    glDeleteBuffers(1, &this->indexBuffer);
  }
  this->vertexArray = this->indexBuffer = 0;
  this->capacity = this->bytes = 0;
}

} // namespace shadow
