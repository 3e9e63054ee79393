#include "DepthReach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace shadow::fuzz
{

namespace
{

/// The triangle within the view, in clip space as PixelRays::toClip() has it.
/// @par Source  Sutherland & Hodgman 1974, "Reentrant Polygon Clipping"
std::vector<glm::dvec4> cutByView(const truth::PixelRays& rays, const truth::LocalTriangle& triangle)
{
  const std::array<glm::dvec4, 5> bounds = {glm::dvec4(0.0, 0.0, 1.0, 0.0), {1.0, 0.0, 0.0, 1.0},
                                            {-1.0, 0.0, 0.0, 1.0}, {0.0, 1.0, 0.0, 1.0},
                                            {0.0, -1.0, 0.0, 1.0}};
  std::vector<glm::dvec4> polygon = {rays.toClip(triangle.a), rays.toClip(triangle.b),
                                     rays.toClip(triangle.c)};
  for (const glm::dvec4& bound : bounds)
  {
    std::vector<glm::dvec4> inside;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const glm::dvec4& from = polygon[i];
      const glm::dvec4& to = polygon[(i + 1) % polygon.size()];
      const double start = glm::dot(bound, from);
      const double end = glm::dot(bound, to);
      if (start >= 0.0)
      {
        inside.push_back(from);
      }
      if ((start >= 0.0) != (end >= 0.0))
      {
        inside.push_back(glm::mix(from, to, start / (start - end)));
      }
    }
    polygon = inside;
  }
  return polygon;
}

double cross(const glm::dvec2& a, const glm::dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}

/// Length over height of the thinnest triangle of three corners of a convex polygon that a point is in.
double getThinness(const std::vector<glm::dvec2>& corners, const glm::dvec2& at)
{
  double thinness = 1.0;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    for (std::size_t j = i + 1; j < corners.size(); ++j)
    {
      for (std::size_t k = j + 1; k < corners.size(); ++k)
      {
        const std::array<glm::dvec2, 3> t = {corners[i], corners[j], corners[k]};
        const double a = cross(t[1] - t[0], at - t[0]);
        const double b = cross(t[2] - t[1], at - t[1]);
        const double c = cross(t[0] - t[2], at - t[2]);
        const double area = std::abs(cross(t[1] - t[0], t[2] - t[0]));
        if (area > 0.0 && ((a >= 0.0 && b >= 0.0 && c >= 0.0) || (a <= 0.0 && b <= 0.0 && c <= 0.0)))
        {
          const double length =
              std::max({glm::distance(t[0], t[1]), glm::distance(t[1], t[2]), glm::distance(t[2], t[0])});
          thinness = std::max(thinness, length * length / area);
        }
      }
    }
  }
  return thinness;
}

} // namespace

double getDepthReach(const truth::PixelRays& rays, const glm::dvec2& size, const glm::dvec2& at,
                     const truth::Ray& ray, const truth::LocalTriangle& triangle, const truth::Hit& hit)
{
  const double near = glm::distance(ray.origin, hit.point);
  double reach = near;
  for (const glm::dvec3& corner : {triangle.a, triangle.b, triangle.c})
  {
    reach = std::max(reach, truth::largestCoordinate(ray.origin) + truth::largestCoordinate(corner));
  }
  const glm::dvec4 seen = rays.toClip(hit.point);
  // Depth is linear on the screen: in parallel views the height over the near plane, else the reciprocal of
  // the distance. As a distance at the place of the hit:
  const auto toDistance = [&](const glm::dvec4& clip)
  { return rays.eye().w == 0.0 ? clip.z * near / seen.z : seen.w * seen.w / clip.w; };
  if (rays.eye().w == 0.0)
  {
    reach = std::max(reach, std::abs(toDistance({0.0, 0.0, 1.0, 1.0})));
  }
  const glm::dvec3 normal = glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
  for (const glm::dvec2& corner : {glm::dvec2(0.0), glm::dvec2(size.x, 0.0), glm::dvec2(0.0, size.y), size})
  {
    const truth::Ray other = rays.through(corner.x, corner.y);
    const double along = glm::dot(normal, triangle.a - other.origin) / glm::dot(normal, other.direction);
    reach = std::max(reach, std::abs(toDistance(rays.toClip(other.origin + along * other.direction))));
  }
  std::vector<glm::dvec2> corners;
  double least = toDistance(seen);
  double most = least;
  for (const glm::dvec4& clip : cutByView(rays, triangle))
  {
    corners.push_back(rays.toPixels(clip));
    least = std::min(least, toDistance(clip));
    most = std::max(most, toDistance(clip));
  }
  return std::max(reach, (most - least) * getThinness(corners, at));
}

} // namespace shadow::fuzz
