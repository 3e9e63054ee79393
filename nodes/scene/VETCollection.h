#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include <glm/glm.hpp>

#include "FacingBits.h"
#include "NodeVisitor.h"
#include "SEDGeometry.h"
#include "SceneFrame.h"

namespace shadow
{

/// The part of a VETCollection that is one geode under one path: its geometry's vertices, triangles and
/// edges, in the geometry's order.
struct VETRange
{
  NodePath path; ///< from the root to the geode
  std::shared_ptr<const SEDGeometry> geometry;
  glm::dmat4 modelToWorld{1.0};
  bool casting = true;
  bool mirrored = false; ///< modelToWorld turns counter-clockwise into clockwise
  std::uint32_t firstVertex = 0;
  std::uint32_t firstTriangle = 0;
  std::uint32_t firstEdge = 0;
  std::uint64_t positionRevision = 0; ///< larger whenever positions changed, corner order with them

  std::size_t countVertices() const { return this->geometry->getPositions().size(); }
  std::size_t countTriangles() const { return this->geometry->getTriangles().size(); }
  std::size_t countEdges() const { return this->geometry->getEdges().size(); }
};

/// All vertices, edges and triangles of a subgraph in one set of arrays and one coordinate system, for the
/// methods that have the GPU look at all of them at once.
///
/// A geode that several paths lead to is there once for each. Triangles and edges are oriented as in the
/// world: those of a mirrored geode are turned, so that the front of an oriented triangle is the side that is
/// the front in model space, too, and counter-clockwise seen from there.
///
/// @par Source  Shi 2006, chapter 4.3.2
struct VETCollection
{
  SceneFrame frame;
  std::vector<glm::vec3> high; ///< a vertex, scene space: see SplitVector
  std::vector<glm::vec3> low;
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< vertices, in the geometry's raster order
  FacingBits reversed;     ///< bit t set: oriented triangle t runs against its raster order
  std::vector<Edge> edges; ///< as in SEDGeometry; vertices and triangles of this collection
  std::vector<VETRange> ranges;
  std::map<NodePath, std::size_t> rangeOfPath; ///< places in ranges
  std::uint64_t topologyRevision = 0; ///< larger whenever anything but positions and corner order changed

  /// The part under a path; nullptr when there is none, as for a transform that flattens.
  const VETRange* find(const NodePath& path) const;

  std::size_t getMemorySize() const;
};

} // namespace shadow
