#pragma once

#include <cstddef>

namespace shadow
{

/// Five vertices and three triangles for each of a number of edges, as numbers only: a quad and one triangle
/// of a fan, see shaders/sides.vert. One serves all geometries, since number 5 e + c means corner c of edge e
/// in each.
///
/// @par Memory  36 bytes an edge of the largest geometry
class EdgeQuads
{
public:
  EdgeQuads() = default;
  EdgeQuads(const EdgeQuads&) = delete;
  EdgeQuads& operator=(const EdgeQuads&) = delete;

  /// Draws edges 0 to @p edges - 1 with the current program.
  /// @param withFan  the fan's triangles, too
  void draw(std::size_t edges, bool withFan);

  void release(bool contextLost = false);
  std::size_t getMemorySize() const { return this->bytes; }

private:
  void reserve(std::size_t edges);

  unsigned int vertexArray = 0;
  unsigned int indexBuffer = 0; ///< first the quads of all edges, then their fan triangles
  std::size_t capacity = 0;     ///< edges
  std::size_t bytes = 0;
};

} // namespace shadow
