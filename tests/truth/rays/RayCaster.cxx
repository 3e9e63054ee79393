#include "RayCaster.h"

namespace shadow::truth
{

namespace
{

bool isFinite(const Triangle& triangle)
{
  bool finite = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    finite = finite && std::isfinite(triangle.a[axis]) && std::isfinite(triangle.b[axis]) &&
             std::isfinite(triangle.c[axis]);
  }
  return finite;
}

/// The centre of the scene, moved to a grid as coarse as the scene is wide. Grid points have so few digits
/// that subtracting one from a vertex is exact up to the vertex's own last place, and a scene around 0 is not
/// moved.
glm::dvec3 gridOrigin(const Box& bounds)
{
  glm::dvec3 origin(0.0);
  const glm::dvec3 size = bounds.high - bounds.low;
  const double widest = std::max({size.x, size.y, size.z});
  if (widest > 0.0 && std::isfinite(widest))
  {
    const double cell = std::exp2(std::ceil(std::log2(widest)));
    origin = glm::round(glm::dvec3(0.5 * bounds.low + 0.5 * bounds.high) / cell) * cell;
  }
  return origin;
}

Box paddedBox(const LocalTriangle& triangle, double padding)
{
  Box box;
  box.add(triangle.a);
  box.add(triangle.b);
  box.add(triangle.c);
  box.low -= padding;
  box.high += padding;
  return box;
}

} // namespace

std::optional<Hit> hitTriangle(const LocalTriangle& triangle, const Ray& ray)
{
  const LineVolumes volumes = lineVolumes(triangle, ray.origin, ray.direction);
  const double total = volumes.u + volumes.v + volumes.w; // 2 direction . normal
  if (!volumes.crosses() || total == 0.0)
  {
    return std::nullopt;
  }
  if (total * ray.frontSign > 0.0 ? triangle.hideFront : triangle.hideBack)
  {
    return std::nullopt;
  }
  // Interpolated from the vertices, not walked to along the ray: so it lies in the plane however far the
  // camera is.
  Hit hit;
  hit.point = (volumes.u * triangle.a + volumes.v * triangle.b + volumes.w * triangle.c) / total;
  hit.distance = glm::dot(hit.point - ray.origin, ray.direction);
  hit.triangle = triangle.index;
  hit.eyeSide = total > 0.0 ? -1 : 1;
  return hit.distance > 0.0 ? std::make_optional(hit) : std::nullopt;
}

bool blocks(const LocalTriangle& triangle, const glm::dvec3& point, double pointRounding,
            const glm::dvec3& direction, const LocalLight& light)
{
  return triangle.casts && separates(triangle, point, pointRounding, direction, light);
}

bool separates(const LocalTriangle& triangle, const glm::dvec3& point, double pointRounding,
               const glm::dvec3& direction, const LocalLight& light)
{
  if (!lineVolumes(triangle, point, direction).crosses())
  {
    return false;
  }
  const int pointSide = sideOfPlane(triangle, glm::dvec4(point, 1.0), pointRounding);
  return pointSide != 0 && sideOfPlane(triangle, light.position, light.rounding) == -pointSide;
}

RayCaster::RayCaster(const Scene& scene)
{
  Box bounds;
  for (const Triangle& triangle : scene.triangles)
  {
    if (isFinite(triangle))
    {
      bounds.add(triangle.a);
      bounds.add(triangle.b);
      bounds.add(triangle.c);
    }
  }
  this->origin = gridOrigin(bounds);

  std::vector<LocalTriangle> locals;
  std::vector<Box> boxes;
  const double padding = 1e-12 * std::sqrt(bounds.halfArea());
  for (std::size_t i = 0; i < scene.triangles.size(); ++i)
  {
    const Triangle& triangle = scene.triangles[i];
    if (isFinite(triangle))
    {
      const double largest = std::max(
          {largestCoordinate(triangle.a), largestCoordinate(triangle.b), largestCoordinate(triangle.c)});
      locals.push_back({triangle.a - this->origin, triangle.b - this->origin, triangle.c - this->origin,
                        vertexRounding(largest), static_cast<std::uint32_t>(i), triangle.casts,
                        triangle.hideFront, triangle.hideBack});
      boxes.push_back(paddedBox(locals.back(), padding));
    }
  }
  this->bvh = TruthBvh(boxes);
  this->triangles.reserve(locals.size());
  for (const std::uint32_t item : this->bvh.order())
  {
    this->triangles.push_back(locals[item]);
  }
}

LocalLight RayCaster::localLight(const Light& light) const
{
  const glm::dvec4& p = light.positionWC;
  if (p.w == 0.0)
  {
    return {p, 0.0};
  }
  const glm::dvec3 positionWC = glm::dvec3(p) / p.w;
  return {glm::dvec4(positionWC - this->origin, 1.0), vertexRounding(largestCoordinate(positionWC))};
}

std::optional<Hit> RayCaster::firstHit(const Ray& ray) const
{
  std::optional<Hit> nearest;
  double farthest = std::numeric_limits<double>::infinity();
  this->bvh.traverse(ray.origin, ray.direction, farthest,
                     [&](std::uint32_t position)
                     {
                       std::optional<Hit> hit = hitTriangle(this->triangles[position], ray);
                       if (hit && hit->distance < farthest)
                       {
                         farthest = hit->distance;
                         nearest = hit;
                         nearest->position = position;
                       }
                       return false;
                     });
  return nearest;
}

bool RayCaster::isReached(const Hit& hit, const LocalLight& light) const
{
  const int lightSide = sideOfPlane(this->triangles[hit.position], light.position, light.rounding);
  return lightSide == hit.eyeSide && !this->isBlocked(hit, light);
}

bool RayCaster::isBlocked(const Hit& hit, const LocalLight& light) const
{
  const glm::dvec3 direction = glm::dvec3(light.position) - light.position.w * hit.point;
  const double rounding = this->triangles[hit.position].rounding;
  const double farthest = light.position.w == 0.0 ? std::numeric_limits<double>::infinity() : 1.0;
  bool blocked = false;
  this->bvh.traverse(hit.point, direction, farthest,
                     [&](std::uint32_t position)
                     {
                       blocked = position != hit.position &&
                                 blocks(this->triangles[position], hit.point, rounding, direction, light);
                       return blocked;
                     });
  return blocked;
}

Answer RayCaster::answer(const Ray& ray, const LocalLight& light) const
{
  const std::optional<Hit> hit = this->firstHit(ray);
  if (!hit)
  {
    return Answer::Background;
  }
  return this->isReached(*hit, light) ? Answer::Reached : Answer::Shadowed;
}

bool RayCaster::isCovered(const glm::dvec3& point, double pointRounding, const Ray& ray,
                          const std::array<std::uint32_t, 2>& without) const
{
  const LocalLight eye{glm::dvec4(ray.origin, 1.0), pointRounding};
  const glm::dvec3 direction = ray.origin - point;
  bool covered = false;
  this->bvh.traverse(point, direction, 1.0,
                     [&](std::uint32_t position)
                     {
                       const LocalTriangle& triangle = this->triangles[position];
                       const glm::dvec3 normal = glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
                       const bool front = glm::dot(normal, ray.direction) * ray.frontSign > 0.0;
                       covered = !(front ? triangle.hideFront : triangle.hideBack) &&
                                 triangle.index != without[0] && triangle.index != without[1] &&
                                 separates(triangle, point, pointRounding, direction, eye);
                       return covered;
                     });
  return covered;
}

} // namespace shadow::truth
