#pragma once

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>

namespace shadow
{

/// An origin for coordinates: the point of a grid nearest to their centre, whose cells are as large as what lies
/// there is wide; 0 along an axis on which a coordinate is less than half or more than twice as far out as that.
///
/// Taking such a point away rounds nothing: coordinates in single precision, as VTK's mostly are, keep every
/// bit, and a light in a triangle's plane stays in it. What lies so close to 0 that it would round is no more
/// than two and a half times as far out as it is wide, and gains nothing.
///
/// @param lower, upper  corners of the bounding box
/// @par Source          Sterbenz 1974, "Floating-Point Computation" (exact differences)
inline glm::dvec3 chooseGridOrigin(const glm::dvec3& lower, const glm::dvec3& upper)
{
  const glm::dvec3 size = upper - lower;
  const double widest = std::max({size.x, size.y, size.z});
  const double cell = std::exp2(std::ceil(std::log2(widest)));
  // Halved before they are added: the sum of two large coordinates may overflow.
  const glm::dvec3 centre = 0.5 * lower + 0.5 * upper;
  if (!(widest > 0.0 && std::isfinite(cell)))
  {
    return centre;
  }
  glm::dvec3 origin = glm::round(centre / cell) * cell;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double nearest = std::min(lower[axis] / origin[axis], upper[axis] / origin[axis]);
    const double farthest = std::max(lower[axis] / origin[axis], upper[axis] / origin[axis]);
    if (!(nearest >= 0.5 && farthest <= 2.0))
    {
      origin[axis] = 0.0;
    }
  }
  return origin;
}

} // namespace shadow
