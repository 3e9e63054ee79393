#include "EdgePoints.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include <vtkShaderProgram.h>

#include "BufferUpload.h"
#include "OpenGL.h"
#include "SEDGeometry.h"

namespace shadow
{

namespace
{

std::uint32_t findThirdCorner(const SEDGeometry& geometry, const Edge& edge, std::uint32_t triangle)
{
  if (triangle == noTriangle)
  {
    return noTriangle;
  }
  const std::array<std::uint32_t, 3>& corners = geometry.getTriangles()[triangle];
  return *std::find_if(corners.begin(), corners.end(),
                       [&](std::uint32_t corner)
                       { return corner != edge.vertices[0] && corner != edge.vertices[1]; });
}

} // namespace

void EdgePoints::upload(const SEDGeometry& geometry)
{
  std::vector<glm::uvec4> points;
  points.reserve(geometry.getEdges().size());
  for (const Edge& edge : geometry.getEdges())
  {
    points.emplace_back(edge.vertices[0], edge.vertices[1],
                        findThirdCorner(geometry, edge, edge.triangles[0]),
                        findThirdCorner(geometry, edge, edge.triangles[1]));
  }
  if (this->buffer == 0)
  {
    glGenVertexArrays(1, &this->vertexArray);
    glGenBuffers(1, &this->buffer);
  }
  this->bytes = uploadBuffer(GL_ARRAY_BUFFER, this->buffer, points, GL_STATIC_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void EdgePoints::draw(vtkShaderProgram* program, std::size_t first, std::size_t count) const
{
  glBindVertexArray(this->vertexArray);
  const GLint place = glGetAttribLocation(static_cast<GLuint>(program->GetHandle()), "edgeVertices");
  if (place >= 0)
  {
    glBindBuffer(GL_ARRAY_BUFFER, this->buffer);
    glEnableVertexAttribArray(static_cast<GLuint>(place));
    glVertexAttribIPointer(static_cast<GLuint>(place), 4, GL_UNSIGNED_INT, sizeof(glm::uvec4), nullptr);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
  }
  glDrawArrays(GL_POINTS, static_cast<GLint>(first), static_cast<GLsizei>(count));
  glBindVertexArray(0);
}

void EdgePoints::release(bool contextLost)
{
  if (!contextLost && this->buffer != 0)
  {
    glDeleteVertexArrays(1, &this->vertexArray);
    glDeleteBuffers(1, &this->buffer);
  }
  this->vertexArray = this->buffer = 0;
  this->bytes = 0;
}

} // namespace shadow
