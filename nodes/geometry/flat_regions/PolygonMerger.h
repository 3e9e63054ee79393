#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>

#include "EdgeTable.h"
#include "TriangleSides.h"

namespace shadow
{

/// Merges triangles into polygons by removing the edges between them, on OpenMesh's polygon mesh.
///
/// OpenMesh's own remove_edge() refuses edges between two faces that share several, which every vertex inside
/// a polygon and every hole asks for. Here such an edge stays in the polygon's walk, with the polygon on both
/// of its sides: it leads to a vertex within, or from the outer border to that of a hole, so that one walk
/// meets all borders.
class PolygonMerger
{
public:
  /// @param meshEdges  as they were handed to @p sides; kept by reference
  PolygonMerger(const std::vector<Edge>& meshEdges, const TriangleSides& sides, std::size_t vertices);

  /// Makes one polygon of those on the two sides of an edge; nothing to do when they are one already.
  ///
  /// @pre   the edge has two triangles
  /// @par Cost  O(sides of the smaller polygon): O(triangles * log(triangles)) for all edges together
  void merge(std::uint32_t edge);

  /// Border of the polygon that a triangle has become part of: vertices from and to of each side, in walking
  /// order, without what has the polygon on both sides.
  std::vector<std::array<std::uint32_t, 2>> readBorder(std::uint32_t triangle) const;

private:
  OpenMesh::FaceHandle findPolygon(std::uint32_t triangle) const;

  const std::vector<Edge>& edges;
  OpenMesh::PolyConnectivity mesh;
  std::vector<std::uint32_t> valences; ///< of each face
  std::vector<int> mergedInto;         ///< of each face: itself, or the one that it became part of
};

} // namespace shadow
