#pragma once

#include <cstddef>

#include "SEDGeometry.h"

namespace shadow
{

/// The triangles of a SEDGeometry with what lies across their edges, as GL_TRIANGLES_ADJACENCY: numbers of
/// vertices only, which a shader looks up in GeometryTexels.
///
/// Corners 0, 2 and 4 are the triangle as it is oriented, each followed by the third vertex of the neighbour
/// across the edge that starts there. A border has no neighbour: the corner stands there once more, which no
/// neighbour's third vertex can be. The smallest corner comes first, so that a mesh that has moved has the
/// same.
///
/// @par Memory  24 bytes a triangle
/// @par Source  Zerari & Babahenini 2011, section 5.2
class AdjacentTriangles
{
public:
  explicit AdjacentTriangles(const SEDGeometry& geometry);
  AdjacentTriangles(const AdjacentTriangles&) = delete;
  AdjacentTriangles& operator=(const AdjacentTriangles&) = delete;

  /// Draws all of them with the current program.
  void draw() const;

  /// Frees the GL objects. @pre their context is current, or is gone and @p contextLost
  void release(bool contextLost = false);
  std::size_t getMemorySize() const { return this->bytes; }

private:
  unsigned int vertexArray = 0;
  unsigned int indexBuffer = 0;
  std::size_t indices = 0;
  std::size_t bytes = 0;
};

} // namespace shadow
