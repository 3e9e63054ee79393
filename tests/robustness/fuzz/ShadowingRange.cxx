#include "ShadowingRange.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace shadow::fuzz
{

namespace
{

/// 1 or -1: the side on which all of the cube is. 0: it reaches both, or rounding does.
int findSide(double value, double uncertainty)
{
  return value > uncertainty ? 1 : value < -uncertainty ? -1 : 0;
}

/// Of the plane through the point and an edge from @p from to @p to, both relative to the point.
int sideOfEdge(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& direction, double halfSide,
               double rounding)
{
  const glm::dvec3 normal = glm::cross(from, to);
  const glm::dvec3 size = glm::abs(normal);
  const double moved = halfSide * (size.x + size.y + size.z);
  const double turned = rounding * (glm::length(from) + glm::length(to)) * glm::length(direction);
  return findSide(glm::dot(normal, direction), moved + turned);
}

} // namespace

Shadowing findShadowing(const truth::LocalTriangle& triangle, const glm::dvec3& point, double pointRounding,
                        const glm::dvec4& light, double halfSide)
{
  const glm::dvec3 normal = glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
  if (std::abs(glm::dot(normal, point - triangle.a)) <=
      std::max(pointRounding, triangle.rounding) * glm::length(normal))
  {
    return Shadowing::Never;
  }
  // 0: off the plane, but rounding of the corners may turn the plane past the point. A sliver's may be any.
  const int pointSide = truth::sideOfPlane(triangle, glm::dvec4(point, 1.0), pointRounding);
  const glm::dvec3 size = glm::abs(normal);
  const glm::dvec3 fromCorner = glm::dvec3(light) - light.w * triangle.a;
  const double tilt = triangle.rounding * glm::length(fromCorner) *
                      (glm::length(triangle.b - triangle.a) + glm::length(triangle.c - triangle.a));
  const double shift = light.w * triangle.rounding * glm::length(normal);
  const int lightSide =
      findSide(glm::dot(normal, fromCorner), tilt + shift + halfSide * (size.x + size.y + size.z));
  if (pointSide != 0 && lightSide == pointSide)
  {
    return Shadowing::Never;
  }
  const glm::dvec3 direction = glm::dvec3(light) - light.w * point;
  const std::array<glm::dvec3, 3> corners = {triangle.a - point, triangle.b - point, triangle.c - point};
  std::array<bool, 3> taken{}; // -1, 0, 1
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    const int side =
        sideOfEdge(corners[corner], corners[(corner + 1) % 3], direction, halfSide, triangle.rounding);
    taken[static_cast<std::size_t>(side + 1)] = true;
  }
  if (taken[0] && taken[2])
  {
    return Shadowing::Never;
  }
  return taken[1] || lightSide == 0 || pointSide == 0 ? Shadowing::Sometimes : Shadowing::Always;
}

} // namespace shadow::fuzz
