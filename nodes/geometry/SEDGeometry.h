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

#include "FacingBits.h"
#include "PreparedData.h"

namespace shadow
{

/// Stands where an edge has no second triangle.
inline constexpr std::uint32_t noTriangle = std::numeric_limits<std::uint32_t>::max();

/// Triangles as they come from a file or a pipeline: no adjacency, duplicates allowed.
struct TriangleSoup
{
  std::vector<glm::dvec3> points;                      ///< model space, any unit
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< indices into points
};

/// An edge and the triangles on its two sides.
struct Edge
{
  std::array<std::uint32_t, 2> vertices;  ///< from, to
  std::array<std::uint32_t, 2> triangles; ///< [0] runs through the edge as from -> to, [1] as to -> from;
                                          ///< [1] is noTriangle on a border
};

/// Plane of an oriented triangle: dot(normal, p) + offset > 0 in front of it. Not normalised; model space
/// relative to the geometry's origin.
struct TrianglePlane
{
  glm::dvec3 normal;
  double offset;
};

/// Bounds of the rounding errors of the planes of 64 consecutive triangles (one word of FacingBits).
///
/// For a light L, dot(normal, L.xyz) + offset * L.w, evaluated in double precision, is off by at most
/// direction * (|L.x| + |L.y| + |L.z|) + position * |L.w|, so that its sign is known where it is larger.
struct PlaneError
{
  double direction = 0.0;
  double position = 0.0;
};

/// How buildSEDGeometry() treats its input.
struct SEDGeometryOptions
{
  /// Points closer than this (model units) become one vertex. 0 welds points whose float32 coordinates
  /// relative to the origin are equal.
  double weldTolerance = 0.0;
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
/// edge has one or two triangles and sums over triangles stay what they were.
///
/// @par Memory  about 80 bytes a triangle
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

  /// Bit t set: the oriented triangle t runs against its raster order.
  const FacingBits& getReversed() const { return this->reversed; }

  /// Bit t set: triangle t ran against its raster order in the input, which is what face culling goes by.
  const FacingBits& getInputReversed() const { return this->inputReversed; }

  /// Plane of each oriented triangle.
  const std::vector<TrianglePlane>& getPlanes() const { return this->planes; }

  /// One a word of FacingBits: entry t / 64 holds for triangle t.
  const std::vector<PlaneError>& getPlaneErrors() const { return this->planeErrors; }

  /// Every edge once. A border edge runs as its triangle's oriented boundary does.
  const std::vector<Edge>& getEdges() const { return this->edges; }

  /// True when no edge is a border: the mesh then bounds a solid (of one or more components).
  bool isClosed() const { return this->report.borderEdges == 0 && !this->triangles.empty(); }

  /// The plane that all vertices lie in, up to one part in a million of the mesh's size: dot(plane, (p, 1)) =
  /// 0, relative to the origin, normalised. Nothing when there is none.
  const std::optional<glm::dvec4>& getCommonPlane() const { return this->commonPlane; }

  /// Bounding box relative to the origin; lower > upper when the geometry is empty.
  const glm::dvec3& getLowerBound() const { return this->lowerBound; }
  const glm::dvec3& getUpperBound() const { return this->upperBound; }

  const SEDGeometryReport& getReport() const { return this->report; }

  /// What silhouette methods have prepared from this mesh; lives as long as the mesh, and its copies, do.
  PreparedData& getPreparedData() const { return *this->prepared; }

  /// Bytes held by the arrays and by what was prepared from them.
  std::size_t getMemorySize() const;

private:
  friend class SEDGeometryBuilder;

  glm::dvec3 origin{0.0};
  std::vector<glm::vec3> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  FacingBits reversed;
  FacingBits inputReversed;
  std::vector<TrianglePlane> planes;
  std::vector<PlaneError> planeErrors;
  std::vector<Edge> edges;
  glm::dvec3 lowerBound{std::numeric_limits<double>::max()};
  glm::dvec3 upperBound{std::numeric_limits<double>::lowest()};
  std::optional<glm::dvec4> commonPlane;
  std::shared_ptr<PreparedData> prepared = std::make_shared<PreparedData>();
  SEDGeometryReport report;
};

/// Builds the adjacency of a triangle soup: weld, drop degenerate triangles, connect through OpenMesh,
/// orient, compute planes.
///
/// @param soup   taken by value so that its memory can be given back early
/// @return       nothing when the input cannot be used (a point is NaN or infinite, an index is out of range,
///               or no triangle is left); @p error then holds one line that says why
/// @par Cost     O(triangles), below 1 microsecond a triangle; peak below 250 bytes a triangle
std::optional<SEDGeometry> buildSEDGeometry(TriangleSoup soup, const SEDGeometryOptions& options,
                                            std::string& error);

} // namespace shadow
