#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

namespace shadow
{

/// Points after welding.
struct WeldedPoints
{
  std::vector<glm::vec3> positions;    ///< one a vertex, relative to the origin; -0 is stored as +0
  std::vector<std::uint32_t> vertexOf; ///< vertex of each point; unspecified for points that were not wanted
};

/// Merges points into vertices; the point with the smallest index gives the vertex its place in the order.
///
/// @param points     model space; those wanted must be finite
/// @param wanted     one entry a point: non-zero when some triangle uses it
/// @param origin     subtracted in double precision before rounding to float32
/// @param tolerance  model units. Not above 0 (or too small to matter at this size): equal float32
/// coordinates
///                   weld. Else a point joins the earliest vertex that is closer than this
/// @param sizeHint   about how many vertices there will be
/// @post  no two vertices have equal positions
/// @par Cost  O(points), expected; 8 to 16 bytes a wanted point besides the result
WeldedPoints weldPoints(const std::vector<glm::dvec3>& points, const std::vector<std::uint8_t>& wanted,
                        const glm::dvec3& origin, double tolerance, std::size_t sizeHint);

} // namespace shadow
