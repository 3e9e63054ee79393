#pragma once

#include <cstddef>

class vtkShaderProgram;

namespace shadow
{

class SEDGeometry;

/// Every edge of a geometry as a point that carries four vertices: its ends, and the third corners of its
/// triangles. Attribute: edgeVertices (uvec4), see shaders/edgeStates.vert.
///
/// @par Memory  16 bytes an edge
/// @par Source  Brabec & Seidel 2003
class EdgePoints
{
public:
  EdgePoints() = default;
  EdgePoints(const EdgePoints&) = delete;
  EdgePoints& operator=(const EdgePoints&) = delete;

  void upload(const SEDGeometry& geometry);
  void draw(vtkShaderProgram* program, std::size_t first, std::size_t count) const;

  void release(bool contextLost = false);
  std::size_t getMemorySize() const { return this->bytes; }

private:
  unsigned int vertexArray = 0;
  unsigned int buffer = 0;
  std::size_t bytes = 0;
};

} // namespace shadow
