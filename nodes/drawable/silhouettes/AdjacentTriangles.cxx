#include "AdjacentTriangles.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "BufferUpload.h"
#include "OpenGL.h"

namespace shadow
{

namespace
{

using Hexagon = std::array<std::uint32_t, 6>; ///< corners at even places, neighbours' vertices between them

std::vector<Hexagon> makeWithoutNeighbours(const SEDGeometry& geometry)
{
  std::vector<Hexagon> triangles;
  triangles.reserve(geometry.getTriangles().size());
  for (std::array<std::uint32_t, 3> corners : geometry.getTriangles())
  {
    if (geometry.getReversed().test(triangles.size()))
    {
      std::swap(corners[1], corners[2]);
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    triangles.push_back({corners[0], corners[0], corners[1], corners[1], corners[2], corners[2]});
  }
  return triangles;
}

/// Where the edge that starts at a vertex has its neighbour. @pre the vertex is a corner
std::size_t placeAfter(const Hexagon& triangle, std::uint32_t vertex)
{
  return triangle[0] == vertex ? 1 : triangle[2] == vertex ? 3 : 5;
}

/// The corner that an edge does not have, from the place of its neighbour.
std::uint32_t oppositeOf(const Hexagon& triangle, std::size_t place)
{
  return triangle[(place + 3) % 6];
}

} // namespace

AdjacentTriangles::AdjacentTriangles(const SEDGeometry& geometry)
{
  std::vector<Hexagon> triangles = makeWithoutNeighbours(geometry);
  for (const Edge& edge : geometry.getEdges())
  {
    if (edge.triangles[1] == noTriangle)
    {
      continue;
    }
    Hexagon& there = triangles[edge.triangles[0]];
    Hexagon& back = triangles[edge.triangles[1]];
    const std::size_t placeThere = placeAfter(there, edge.vertices[0]);
    const std::size_t placeBack = placeAfter(back, edge.vertices[1]);
    there[placeThere] = oppositeOf(back, placeBack);
    back[placeBack] = oppositeOf(there, placeThere);
  }
  this->indices = 6 * triangles.size();
  glGenVertexArrays(1, &this->vertexArray);
  glGenBuffers(1, &this->indexBuffer);
  glBindVertexArray(this->vertexArray);
  this->bytes = uploadBuffer(GL_ELEMENT_ARRAY_BUFFER, this->indexBuffer, triangles, GL_STATIC_DRAW);
  glBindVertexArray(0);
}

void AdjacentTriangles::draw() const
{
  glBindVertexArray(this->vertexArray);
  glDrawElements(GL_TRIANGLES_ADJACENCY, static_cast<GLsizei>(this->indices), GL_UNSIGNED_INT, nullptr);
  glBindVertexArray(0);
}

void AdjacentTriangles::release(bool contextLost)
{
  if (!contextLost)
  {
    glDeleteVertexArrays(1, &this->vertexArray);
    glDeleteBuffers(1, &this->indexBuffer);
  }
  this->vertexArray = this->indexBuffer = 0;
  this->bytes = 0;
}

} // namespace shadow
