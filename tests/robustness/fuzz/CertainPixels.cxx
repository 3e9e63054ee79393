#include "CertainPixels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shadow::fuzz
{

namespace
{

constexpr double roundings = 32.0 * std::numeric_limits<double>::epsilon();

double getLargestCoordinate(const truth::Scene& scene, const glm::dvec4& lightPosition)
{
  double largest = truth::largestCoordinate(glm::dvec3(lightPosition));
  for (const truth::Triangle& triangle : scene.triangles)
  {
    for (const glm::dvec3& corner : {triangle.a, triangle.b, triangle.c})
    {
      largest = std::max(largest, truth::largestCoordinate(corner));
    }
  }
  return largest;
}

std::vector<truth::LocalLight> moveLight(const truth::RayCaster& caster, const truth::Scene& scene,
                                         const truth::Light& light)
{
  const bool isPositional = light.positionWC.w != 0.0;
  const double far = roundings * (isPositional ? getLargestCoordinate(scene, light.positionWC) : 1.0);
  std::vector<truth::LocalLight> moved = {caster.localLight(light)};
  for (int corner = 0; corner < 8; ++corner)
  {
    truth::LocalLight at = caster.localLight(light);
    for (int axis = 0; axis < 3; ++axis)
    {
      at.position[axis] += ((corner >> axis) & 1) != 0 ? far : -far;
    }
    moved.push_back(at);
  }
  return moved;
}

/// In the ray caster's space.
std::vector<truth::LocalTriangle> makeTriangles(const truth::RayCaster& caster, const truth::Scene& scene,
                                                bool doublePoints)
{
  // From roundings of double to roundings of single precision.
  const double coarser = doublePoints ? std::exp2(29.0) : 1.0;
  std::vector<truth::LocalTriangle> triangles;
  for (const truth::Triangle& triangle : scene.triangles)
  {
    const double largest =
        std::max({truth::largestCoordinate(triangle.a), truth::largestCoordinate(triangle.b),
                  truth::largestCoordinate(triangle.c)});
    triangles.push_back({triangle.a - caster.originWC(), triangle.b - caster.originWC(),
                       triangle.c - caster.originWC(), coarser * truth::vertexRounding(largest),
                       static_cast<std::uint32_t>(triangles.size()), triangle.casts, false, false});
  }
  return triangles;
}

bool isGrazing(const truth::LocalTriangle& triangle, const glm::dvec3& direction)
{
  const glm::dvec3 normal = glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
  return std::abs(glm::dot(normal, direction)) < 1e-6 * glm::length(normal) * glm::length(direction);
}

} // namespace

CertainPixels::CertainPixels(const truth::Scene& scene, const truth::View& view,
                             const truth::Light& light, bool doublePoints)
    : caster(scene), truth(caster, view, light), rays(view, caster.originWC()),
      triangles(makeTriangles(caster, scene, doublePoints)),
      movedLights(moveLight(caster, scene, light)), known(truth.mask().size(), -1)
{
}

bool CertainPixels::isCertain(int x, int y) const
{
  const std::size_t pixel = static_cast<std::size_t>(y) * this->getWidth() + x;
  signed char& certain = this->known[pixel];
  if (certain < 0)
  {
    const truth::Ray ray = this->rays.through(x + 0.5, y + 0.5);
    const bool isShadowed = this->getMask()[pixel] == 0;
    certain = this->truth.isCertain(x, y) && this->hasSameAnswerNearby(ray, isShadowed) &&
                      !this->isInPlaneOfLight(ray)
                  ? 1
                  : 0;
  }
  return certain != 0;
}

bool CertainPixels::hasSameAnswerNearby(const truth::Ray& ray, bool isShadowed) const
{
  return std::all_of(this->movedLights.begin(), this->movedLights.end(),
                     [&](const truth::LocalLight& moved)
                     { return (this->caster.answer(ray, moved) == truth::Answer::Shadowed) == isShadowed; });
}

bool CertainPixels::isInPlaneOfLight(const truth::Ray& ray) const
{
  const std::optional<truth::Hit> hit = this->caster.firstHit(ray);
  for (std::size_t i = 0; hit && i < this->triangles.size(); ++i)
  {
    for (const truth::LocalLight& moved : this->movedLights)
    {
      const glm::dvec3 direction = glm::dvec3(moved.position) - moved.position.w * hit->point;
      if (i == hit->triangle && isGrazing(this->triangles[i], direction))
      {
        return true;
      }
      if ((i == hit->triangle || truth::lineVolumes(this->triangles[i], hit->point, direction).crosses()) &&
          truth::sideOfPlane(this->triangles[i], moved.position, moved.rounding) == 0)
      {
        return true;
      }
    }
  }
  return false;
}

bool CertainPixels::isOneSurface(int x, int y) const
{
  constexpr double depthStep = 1.0 / (1 << 21);
  const truth::Ray ray = this->rays.through(x + 0.5, y + 0.5);
  std::vector<double> depths;
  for (const truth::LocalTriangle& triangle : this->triangles)
  {
    if (const std::optional<truth::Hit> hit = truth::hitTriangle(triangle, ray))
    {
      const glm::dvec4 clip = this->rays.toClip(hit->point);
      depths.push_back(clip.z / clip.w);
    }
  }
  std::sort(depths.begin(), depths.end());
  return depths.size() < 2 || depths[1] - depths[0] > depthStep;
}

std::size_t CertainPixels::countCertain() const
{
  std::size_t count = 0;
  for (int y = 0; y < this->getHeight(); ++y)
  {
    for (int x = 0; x < this->getWidth(); ++x)
    {
      count += this->isCertain(x, y) ? 1 : 0;
    }
  }
  return count;
}

} // namespace shadow::fuzz
