#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "ClusterTree.h"
#include "EdgeTable.h"
#include "FacingBits.h"
#include "ParallelFor.h"
#include "PlaneBlock.h"
#include "PreparedData.h"

namespace shadow
{

/// Triangles as they come from a file or a pipeline: no adjacency, duplicates allowed.
struct TriangleSoup
{
  std::vector<glm::dvec3> points;                      ///< model space, any unit
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< indices into points
};

/// Plane of an oriented triangle: dot(normal, p) + offset > 0 in front of it. Not normalised; model space
/// relative to the geometry's origin.
struct TrianglePlane
{
  glm::dvec3 normal;
  double offset;
};

class SEDGeometry;

/// How buildSEDGeometry() treats its input.
struct SEDGeometryOptions
{
  /// Points closer than this (model units) become one vertex. 0 welds points whose float32 coordinates
  /// relative to the origin are equal.
  double weldTolerance = 0.0;

  /// For lines: of triangles with the same three corners, wound either way, the first one counts as a part of
  /// the surface, and the others are kept as copies without neighbours. A sheet that is stored front and back
  /// is then one sheet. For volumes each counts.
  bool copiesCountOnce = false;

  /// The same mesh before it deformed, or any other: where it has the same triangles their order is taken
  /// over, so that what was made for it elsewhere fits but for positions, and edges are not looked for again
  /// where it has them: see isSameMeshMoved(). Needed during the call only.
  const SEDGeometry* previous = nullptr;

  /// Threads for large meshes; what is built does not depend on them.
  ParallelFor parallelFor = {};
};

/// What was found, dropped and split while the adjacency was built.
struct SEDGeometryReport
{
  std::size_t inputTriangles = 0;
  std::size_t degenerateTriangles = 0; ///< dropped: two corners welded into one
  std::size_t zeroAreaTriangles = 0;   ///< kept: collinear corners, needed to keep the neighbours connected
  std::size_t borderEdges = 0;         ///< edges with one triangle, those of split edges included
  std::size_t nonManifoldEdges = 0;    ///< distinct vertex pairs with three or more triangles
  std::size_t flippedTriangles = 0;    ///< turned to agree with their neighbours or to look outwards
  std::size_t splitVertices = 0;       ///< extra vertices made where the mesh was not a manifold
};

/// A mesh with the adjacency a silhouette needs, as flat arrays (the thesis's SEDGeometry).
///
/// Vertices are welded; the triangles of each connected component are oriented alike, and outwards (positive
/// signed volume) where the component is closed. Non-manifold edges are split into borders, so that every
/// edge has one or two triangles and sums over triangles stay what they were. Triangles that lie together
/// stand together: the 64 of a word of FacingBits, and the 16 of each of its quarters, are a patch.
///
/// @par Memory  about 35 bytes a triangle
/// @par Source  Shi 2006, chapter 4.2.2
class SEDGeometry
{
public:
  /// Model-space origin that all positions and planes are relative to.
  const glm::dvec3& getOrigin() const { return this->origin; }

  /// Vertex positions relative to the origin.
  const std::vector<glm::vec3>& getPositions() const { return this->positions; }

  /// Three vertices a triangle in raster order: sorted by position (x, then y, then z), so that triangles
  /// with equal corners are rasterised with bit-for-bit equal depth whatever their input order was.
  const std::vector<std::array<std::uint32_t, 3>>& getTriangles() const { return this->triangles; }

  /// For each triangle its place among those of the input, without the degenerate ones.
  const std::vector<std::uint32_t>& getInputOrder() const { return this->inputOrder; }

  /// Bit t set: the oriented triangle t runs against its raster order.
  const FacingBits& getReversed() const { return this->reversed; }

  /// Bit t set: triangle t ran against its raster order in the input, which is what face culling goes by.
  const FacingBits& getInputReversed() const { return this->inputReversed; }

  /// Bit t set: triangle t is a copy of one that counts; see SEDGeometryOptions::copiesCountOnce. Its sides
  /// are borders in the edge table, which are no edges of the surface.
  const FacingBits& getCopies() const { return this->copies; }

  /// The plane of an oriented triangle, computed from its corners.
  TrianglePlane getPlane(std::size_t triangle) const;

  /// Planes, rounded, one block a word of FacingBits.
  const std::vector<PlaneBlock>& getPlaneBlocks() const { return this->planeBlocks; }

  /// The power of two that PlaneBlock::offset is in units of; no vertex has |x| + |y| + |z| above it.
  double getReach() const { return this->reach; }

  /// How far planes turn where corners move by one reach, to first order: the largest (|u| + |v|) / |u x v|
  /// of two sides of a triangle, times the reach. Without triangles that have a plane of zeros.
  double getSharpness() const { return this->sharpness; }

  /// Every edge once, made as they are asked for. A border edge runs as its triangle's oriented boundary
  /// does.
  EdgeList getEdges() const { return EdgeList(*this); }

  /// The same edges as they are stored.
  const EdgeTable& getEdgeTable() const { return this->edgeTable; }

  /// Vertices of a side of a triangle, from and to as the oriented triangle runs through it.
  ///
  /// @param side  0, 1 or 2: between the corners side and (side + 1) % 3 in raster order
  std::array<std::uint32_t, 2> getSide(std::size_t triangle, std::uint32_t side) const
  {
    const std::uint32_t next = side == 2 ? 0 : side + 1;
    const bool backwards = this->reversed.test(triangle);
    return {this->triangles[triangle][backwards ? next : side],
            this->triangles[triangle][backwards ? side : next]};
  }

  /// Of a side, model space.
  double getSquaredLength(std::size_t triangle, std::uint32_t side) const
  {
    const auto [from, to] = this->getSide(triangle, side);
    const glm::dvec3 along = glm::dvec3(this->positions[to]) - glm::dvec3(this->positions[from]);
    return glm::dot(along, along);
  }

  /// What the words of FacingBits have in common.
  const ClusterTree& getClusterTree() const { return this->clusterTree; }

  /// True when no edge is a border: the mesh then bounds a solid (of one or more components).
  bool isClosed() const { return this->report.borderEdges == 0 && !this->triangles.empty(); }

  /// The plane that all vertices lie in, up to one part in a million of the mesh's size: dot(plane, (p, 1)) =
  /// 0, relative to the origin, normalised. Nothing when there is none.
  const std::optional<glm::dvec4>& getCommonPlane() const { return this->commonPlane; }

  /// Bounding box relative to the origin; lower > upper when the geometry is empty.
  const glm::dvec3& getLowerBound() const { return this->lowerBound; }
  const glm::dvec3& getUpperBound() const { return this->upperBound; }

  const SEDGeometryReport& getReport() const { return this->report; }

  /// Another number for each mesh, but for meshes of which isSameMeshMoved() holds; 0 for an empty one.
  std::uint64_t getTopology() const { return this->topology; }

  /// Another number for each mesh, but for those of one topology whose getTriangles(), getReversed() and
  /// getInputReversed() are equal, too; 0 for an empty one.
  std::uint64_t getRasterOrder() const { return this->rasterOrder; }

  /// What silhouette methods have prepared from this mesh; lives as long as the mesh, and its copies, do.
  PreparedData& getPreparedData() const { return *this->prepared; }

  /// Bytes held by the arrays and by what was prepared from them.
  std::size_t getMemorySize() const;

private:
  friend class SEDGeometryBuilder;

  glm::dvec3 origin{0.0};
  std::vector<glm::vec3> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> inputOrder;
  FacingBits reversed;
  FacingBits inputReversed;
  FacingBits copies;
  std::vector<PlaneBlock> planeBlocks;
  double reach = 1.0;
  double sharpness = 0.0;
  EdgeTable edgeTable;
  ClusterTree clusterTree;
  glm::dvec3 lowerBound{std::numeric_limits<double>::max()};
  glm::dvec3 upperBound{std::numeric_limits<double>::lowest()};
  std::optional<glm::dvec4> commonPlane;
  std::shared_ptr<PreparedData> prepared = std::make_shared<PreparedData>();
  SEDGeometryReport report;
  bool manifold = false; ///< no triangle had to be turned or cut off to be connected
  std::uint64_t topology = 0;
  std::uint64_t rasterOrder = 0;
};

/// Whether two geometries are one mesh with its vertices at other places: one was built with the other as
/// SEDGeometryOptions::previous, or with one that is, and has the same vertices, edges and oriented triangles
/// in the same order. What was made from these alone fits both.
/// @par Cost  O(1)
inline bool isSameMeshMoved(const SEDGeometry& one, const SEDGeometry& other)
{
  return one.getTopology() == other.getTopology();
}

/// Builds the adjacency of a triangle soup: weld, drop degenerate triangles, connect, orient, compute
/// planes.
///
/// @param soup   taken by value so that its memory can be given back early
/// @return       nothing when the input cannot be used (a point is NaN or infinite, an index is out of range,
///               or no triangle is left); @p error then holds one line that says why
/// @par Cost     O(triangles), below 1 microsecond a triangle; peak below 250 bytes a triangle
std::optional<SEDGeometry> buildSEDGeometry(TriangleSoup soup, const SEDGeometryOptions& options,
                                            std::string& error);

} // namespace shadow
