#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "PixelRays.h"

namespace shadow::truth
{

/// Stands where an edge has no second triangle.
constexpr std::uint32_t noNeighbour = 0xffffffffu;

/// An edge that an outline drawing shows wherever it is not hidden.
struct OutlineEdge
{
  glm::dvec3 a{0.0}, b{0.0};              ///< the space of the rays
  std::array<std::uint32_t, 2> triangles; ///< in Scene::triangles; the second may be noNeighbour
  bool certain = true;                    ///< false where rounding decides whether it is shown

  /// Where its triangles are, seen from the eye: 1 left of the way from a to b, -1 right, 0 on both sides or
  /// unknown.
  int inside = 0;
};

/// Finds the edges of a scene that its outline consists of: those where a surface turns away from the eye,
/// its borders, and creases where they are asked for.
///
/// Triangles are neighbours when they are of one part, whose triangles stand together, and two of their
/// corners are equal up to single precision at the size of the part. An edge is on the
/// silhouette when more of its triangles lie on one side of the plane through edge and eye than on the
/// other, however they are wound: of two triangles both, and of three always, for one of them is left when
/// the others have been paired. With two or more on each side it is uncertain, as it depends on which are
/// paired. Triangles with the same three corners, however they are wound, count as one: a sheet
/// stored front and back is one sheet. With more than two others there they may be a wall between solids, and
/// what depends on that is uncertain. A border is shown from everywhere. Triangles with two equal corners, or with a coordinate that is
/// not finite, are left out.
///
/// @param creaseDegrees  the least angle between the normals of a crease's triangles; none: no creases
/// @par Cost  O(n log n)
std::vector<OutlineEdge> findOutlineEdges(const Scene& scene, const PixelRays& rays,
                                          const glm::dvec3& originWC,
                                          const std::optional<double>& creaseDegrees);

} // namespace shadow::truth
