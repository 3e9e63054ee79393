#include "NearPlaneLight.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "SceneRounding.h"

namespace shadow::fuzz
{

namespace
{

using Corners = std::array<glm::dvec3, 4>;

/// Of a plane and what is near enough to it, the inside.
struct HalfSpace
{
  glm::dvec3 point, normal;
  double slack;

  double heightOf(const glm::dvec3& other) const
  {
    return glm::dot(other - this->point, this->normal) + this->slack;
  }
};

/// Normal towards a point that is known to be inside.
std::optional<HalfSpace> makeHalfSpace(const glm::dvec3& point, const glm::dvec3& normal,
                                       const glm::dvec3& inside, double size, double rounding)
{
  const double length = glm::length(normal);
  const double height = length > 0.0 ? glm::dot(inside - point, normal) / length : 0.0;
  if (std::abs(height) <= 1e-9 * size)
  {
    return std::nullopt;
  }
  return HalfSpace{point, (height > 0.0 ? 1.0 : -1.0) / length * normal, 1e-7 * size + rounding};
}

/// What lies between the rectangle and the light. Empty when the light is in the rectangle's plane.
std::vector<HalfSpace> makeHull(const Corners& corners, const glm::dvec4& light, double rounding)
{
  const glm::dvec3 centre = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
  const double size = glm::distance(corners[0], corners[2]);
  const glm::dvec3 towards = glm::dvec3(light) - light.w * centre;
  const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[3] - corners[0]);
  const glm::dvec3 above = light.w != 0.0 ? glm::dvec3(light) : centre + size * glm::normalize(towards);
  std::vector<std::optional<HalfSpace>> bounds = {makeHalfSpace(centre, normal, above, size, rounding)};
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const glm::dvec3& corner = corners[i];
    const glm::dvec3 side = corners[(i + 1) % 4] - corner;
    bounds.push_back(
        makeHalfSpace(corner, glm::cross(side, glm::dvec3(light) - light.w * corner),
                                   centre, size, rounding));
  }
  if (light.w != 0.0)
  {
    bounds.push_back(makeHalfSpace(glm::dvec3(light), normal, centre, size, rounding));
  }
  std::vector<HalfSpace> hull;
  for (const std::optional<HalfSpace>& bound : bounds)
  {
    if (!bound)
    {
      return {};
    }
    hull.push_back(*bound);
  }
  return hull;
}

/// @par Source  Sutherland & Hodgman 1974, "Reentrant Polygon Clipping"
std::vector<glm::dvec3> clip(const std::vector<glm::dvec3>& polygon, const HalfSpace& bound)
{
  std::vector<glm::dvec3> inside;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const glm::dvec3& from = polygon[i];
    const glm::dvec3& to = polygon[(i + 1) % polygon.size()];
    const double start = bound.heightOf(from);
    const double end = bound.heightOf(to);
    if (start >= 0.0)
    {
      inside.push_back(from);
    }
    if ((start >= 0.0) != (end >= 0.0))
    {
      inside.push_back(from + start / (start - end) * (to - from));
    }
  }
  return inside;
}

} // namespace

bool isNearPlaneLit(const truth::Scene& scene, const truth::PixelRays& rays, const glm::dvec2& size,
                    const truth::Light& light, bool doublePoints)
{
  const Corners corners = {rays.through(0.0, 0.0).origin, rays.through(size.x, 0.0).origin,
                           rays.through(size.x, size.y).origin, rays.through(0.0, size.y).origin};
  const double rounding = (doublePoints ? fromDoubleToSingle : 1.0) *
                          truth::vertexRounding(getLargestCoordinate(scene, light.positionWC));
  const std::vector<HalfSpace> hull = makeHull(corners, light.positionWC, rounding);
  return !hull.empty() &&
         std::none_of(scene.triangles.begin(), scene.triangles.end(),
                      [&hull](const truth::Triangle& triangle)
                      {
                        std::vector<glm::dvec3> polygon = {triangle.a, triangle.b, triangle.c};
                        for (const HalfSpace& bound : hull)
                        {
                          polygon = clip(polygon, bound);
                        }
                        return !polygon.empty();
                      });
}

} // namespace shadow::fuzz
