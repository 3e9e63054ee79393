#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "EdgeTable.h"

namespace shadow
{

/// The edges of each triangle: what SEDGeometry::getEdges() says, the other way round. Edges have the numbers
/// that they have there.
///
/// Side 2e runs through edge e as from -> to, side 2e + 1 as to -> from; these are OpenMesh's half-edges.
class TriangleSides
{
public:
  /// @param edges      every edge of a mesh: EdgeList::toVector(); not needed later
  /// @param triangles  how many there are
  /// @par Cost    O(edges)
  /// @par Memory  12 bytes a triangle
  TriangleSides(const std::vector<Edge>& edges, std::size_t triangles);

  /// The three sides of a triangle, one after the other round its oriented boundary.
  const std::array<std::uint32_t, 3>& operator[](std::size_t triangle) const { return this->sides[triangle]; }

  std::size_t size() const { return this->sides.size(); }
  std::size_t getMemorySize() const { return this->sides.capacity() * sizeof(this->sides[0]); }

private:
  std::vector<std::array<std::uint32_t, 3>> sides;
};

/// The vertices that a side runs from and to.
inline std::array<std::uint32_t, 2> getSideVertices(const std::vector<Edge>& edges, std::uint32_t side)
{
  const Edge& edge = edges[side >> 1];
  return {edge.vertices[side & 1], edge.vertices[1 - (side & 1)]};
}

/// The triangle across a side, or noTriangle.
inline std::uint32_t getTriangleAcross(const std::vector<Edge>& edges, std::uint32_t side)
{
  return edges[side >> 1].triangles[1 - (side & 1)];
}

} // namespace shadow
