#pragma once

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>

namespace shadow
{

/// An origin for coordinates around a centre: the point nearest to it of a grid whose cells are as large as
/// what lies there is wide.
///
/// Grid points have so few digits that taking one away from a coordinate rounds nothing, and what lies around
/// 0 stays where it is: coordinates in single precision, as VTK's mostly are, keep every bit, and a light in
/// a triangle's plane stays in it.
///
/// @param size  of the bounding box
inline glm::dvec3 nearestGridPoint(const glm::dvec3& centre, const glm::dvec3& size)
{
  const double widest = std::max({size.x, size.y, size.z});
  const double cell = std::exp2(std::ceil(std::log2(widest)));
  return widest > 0.0 && std::isfinite(cell) ? glm::round(centre / cell) * cell : centre;
}

} // namespace shadow
