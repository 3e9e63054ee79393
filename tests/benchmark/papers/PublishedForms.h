#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "FlatRegions.h"
#include "SEDGeometry.h"

namespace shadow::benchmarks
{

/// What an algorithm did, in the kinds that Kolivand & Sunar count.
struct Operations
{
  double additions = 0.0; ///< subtractions, too
  double multiplications = 0.0;
  double comparisons = 0.0;
  double reads = 0.0;  ///< of a coordinate, or of an edge (a pair of vertices) in a face or a list
  double writes = 0.0; ///< of an edge into a list

  Operations& operator+=(const Operations& other);
  Operations operator/(double divisor) const;
};

using DirectedEdge = std::array<std::uint32_t, 2>;

/// A face as the paper has it: any number of sides in one plane.
struct PolygonFace
{
  std::array<std::uint32_t, 3> corners; ///< three vertices that its plane goes through, wound as it is
  std::vector<DirectedEdge> sides;
};

/// Faces over the vertices of a geometry.
struct PolygonMesh
{
  std::vector<glm::vec3> positions;
  std::vector<PolygonFace> faces;
  std::vector<DirectedEdge> edges; ///< each once

  /// Sides a face, on average.
  double getMeanSides() const;
};

PolygonMesh makeTriangleMesh(const SEDGeometry& geometry);

/// Flat regions as one face each; what HSD prepares.
PolygonMesh makeMergedMesh(const SEDGeometry& geometry, const FlatRegions& regions);

/// TA as published: for each face that the light sees, each side is looked for in a list, reversed; found it
/// is taken out, else the side is put in.
///
/// HSD as published is the same over makeMergedMesh().
///
/// @param operations  what was done is added
/// @return  directed edges of the silhouette
/// @par Cost    O(faces * sides * silhouette)
/// @par Source  Kolivand & Sunar 2011, "Hybrid Silhouette Detection for Real-Time Shadow Volume", 6.1, 6.3
std::vector<DirectedEdge> findByTriangular(const PolygonMesh& mesh, const glm::dvec4& lightMC,
                                           Operations& operations);

/// VnV as published: for each edge, the facing of each face is computed, and the faces that the light sees
/// and that have the edge are counted.
///
/// @par Cost    O(edges * faces)
/// @par Source  the same, 6.2
std::vector<DirectedEdge> findByVisibleNonVisible(const PolygonMesh& mesh, const glm::dvec4& lightMC,
                                                  Operations& operations);

} // namespace shadow::benchmarks
