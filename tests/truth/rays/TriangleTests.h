#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include <glm/glm.hpp>

namespace shadow::truth
{

/// A triangle as the ray caster keeps it, in the caster's space.
struct LocalTriangle
{
  glm::dvec3 a, b, c;
  double rounding;     ///< how far a vertex may be off through rounding, see vertexRounding()
  std::uint32_t index; ///< in Scene::triangles
  bool casts, hideFront, hideBack;
};

/// Distance within which two computed points count as one: some units in the last place of the largest
/// coordinate that took part, as a model matrix leaves behind.
inline double vertexRounding(double largestCoordinate)
{
  return 8.0 * std::numeric_limits<double>::epsilon() * largestCoordinate;
}

inline double largestCoordinate(const glm::dvec3& p)
{
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

/// The signed volumes that a line spans with the three edges of a triangle; u, v, w belong to a, b, c.
struct LineVolumes
{
  double u, v, w;
  bool crosses() const
  {
    return (this->u >= 0.0 && this->v >= 0.0 && this->w >= 0.0) ||
           (this->u <= 0.0 && this->v <= 0.0 && this->w <= 0.0);
  }
};

/// An edge seen from the other side gives exactly the negative value, so a line never slips through between
/// two triangles that share the edge; the edge enters as a difference, so a far origin costs no accuracy.
///
/// @par Source  Plücker test in the form of Embree: Woop, Wald et al., TriangleMIntersectorPluecker
inline LineVolumes lineVolumes(const LocalTriangle& triangle, const glm::dvec3& origin,
                               const glm::dvec3& direction)
{
  const glm::dvec3 a = triangle.a - origin;
  const glm::dvec3 b = triangle.b - origin;
  const glm::dvec3 c = triangle.c - origin;
  return {glm::dot(glm::cross(c + b, c - b), direction), glm::dot(glm::cross(a + c, a - c), direction),
          glm::dot(glm::cross(b + a, b - a), direction)};
}

/// The side of the triangle's plane on which a point (w = 1) or a direction (w = 0) lies: +1 where the
/// vertices run counter-clockwise, -1 opposite, 0 in the plane. What rounding of the vertices or of the point
/// could turn into the other side counts as in the plane, so slivers, whose plane is noise, have no sides.
///
/// @param pointRounding  how far the point may be off
inline int sideOfPlane(const LocalTriangle& triangle, const glm::dvec4& point, double pointRounding)
{
  const glm::dvec3 edge1 = triangle.b - triangle.a;
  const glm::dvec3 edge2 = triangle.c - triangle.a;
  const glm::dvec3 normal = glm::cross(edge1, edge2);
  const glm::dvec3 offset = glm::dvec3(point) - point.w * triangle.a;
  const double volume = glm::dot(normal, offset);
  const double tilt = triangle.rounding * (glm::length(edge1) + glm::length(edge2)) * glm::length(offset);
  const double shift = point.w * std::max(pointRounding, triangle.rounding) * glm::length(normal);
  const double bound = tilt + shift;
  return volume > bound ? 1 : volume < -bound ? -1 : 0;
}

} // namespace shadow::truth
