#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>

#include "SEDGeometry.h"

namespace shadow
{

/// Connects triangles into a half-edge structure through OpenMesh and reads the edges off it. One by one, so that it
/// can be told which of them do not fit: for meshes that pairSides() does not take.
///
/// Uses OpenMesh's connectivity alone, without points or properties: 54 bytes a triangle. OpenMesh reports on
/// the standard error stream when it cannot hold a triangle, so every triangle is tried beforehand.
class EdgeConnector
{
public:
  EdgeConnector(std::size_t vertices, std::size_t triangles);

  /// Adds one triangle; triangles are numbered in the order in which they were added.
  ///
  /// @return  false, with nothing changed, when the mesh would not be an oriented manifold with it
  /// @par Cost  O(number of edges at its vertices)
  bool add(const std::array<std::uint32_t, 3>& triangle);

  /// Adds a vertex. @return its index
  std::uint32_t addVertex();

  /// Every edge once, in the order in which they came into being.
  std::vector<Edge> readEdges() const;

private:
  bool canRelink(OpenMesh::HalfedgeHandle incoming, OpenMesh::HalfedgeHandle outgoing) const;
  OpenMesh::HalfedgeHandle findHalfedge(OpenMesh::VertexHandle from, OpenMesh::VertexHandle to) const;

  OpenMesh::TriConnectivity mesh;
};

} // namespace shadow
