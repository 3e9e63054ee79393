#include "CertainPixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "DepthReach.h"
#include "SceneRounding.h"
#include "ShadowingRange.h"

namespace shadow::fuzz
{

namespace
{

constexpr double roundings = 32.0 * std::numeric_limits<double>::epsilon();
constexpr double depthRoundings = 4.0 * std::numeric_limits<float>::epsilon();

/// Half the side of the cube that the light is moved in.
double getHalfSide(const truth::Scene& scene, const truth::Light& light)
{
  const bool isPositional = light.positionWC.w != 0.0;
  return roundings * (isPositional ? getLargestCoordinate(scene, light.positionWC) : 1.0);
}

std::vector<truth::LocalLight> moveLight(const truth::RayCaster& caster, const truth::Light& light, double far)
{
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
  // From roundings of double to those of single precision, of what is drawn: relative to an origin in the
  // scene.
  const double coarser = doublePoints ? fromDoubleToSingle : 1.0;
  const glm::dvec3 drawnFrom = doublePoints ? caster.originWC() : glm::dvec3(0.0);
  std::vector<truth::LocalTriangle> triangles;
  for (const truth::Triangle& triangle : scene.triangles)
  {
    const double largest =
        std::max({truth::largestCoordinate(triangle.a - drawnFrom),
                  truth::largestCoordinate(triangle.b - drawnFrom),
                  truth::largestCoordinate(triangle.c - drawnFrom)});
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

/// Whether a point is on the triangle, seen along its normal.
bool isInPrism(const truth::LocalTriangle& triangle, const glm::dvec3& point, const glm::dvec3& normal)
{
  return truth::lineVolumes(triangle, point - normal, normal).crosses();
}

} // namespace

CertainPixels::CertainPixels(const truth::Scene& scene, const truth::View& view,
                             const truth::Light& light, bool doublePoints)
    : caster(scene), truth(caster, view, light), rays(view, caster.originWC()),
      triangles(makeTriangles(caster, scene, doublePoints)),
      halfSide(getHalfSide(scene, light)), movedLights(moveLight(caster, light, halfSide)),
      outlines(triangles, rays, movedLights.front().position),
      known(truth.mask().size(), -1)
{
}

bool CertainPixels::isCertain(int x, int y) const
{
  const std::size_t pixel = static_cast<std::size_t>(y) * this->getWidth() + x;
  signed char& certain = this->known[pixel];
  if (certain < 0)
  {
    certain = this->findCertainty(x, y) ? 1 : 0;
  }
  return certain != 0;
}

bool CertainPixels::findCertainty(int x, int y) const
{
  const std::size_t pixel = static_cast<std::size_t>(y) * this->getWidth() + x;
  const bool isShadowed = this->getMask()[pixel] == 0;
  const glm::dvec2 centre(x + 0.5, y + 0.5);
  const std::optional<truth::Hit> seen = this->caster.firstHit(this->rays.through(centre.x, centre.y));
  const bool isBackground = !seen;
  if (this->outlines.pass(centre, seen) || this->outlines.passThinVolume(centre))
  {
    return false;
  }
  constexpr double off = truth::MaskTruth::certainOffset;
  const std::array<glm::dvec2, 5> places = {centre, centre + glm::dvec2(-off, -off),
                                            centre + glm::dvec2(-off, off), centre + glm::dvec2(off, -off),
                                            centre + glm::dvec2(off, off)};
  return std::all_of(places.begin(), places.end(),
                     [&](const glm::dvec2& place)
                     {
                       const truth::Ray ray = this->rays.through(place.x, place.y);
                       const std::optional<truth::Hit> hit = this->caster.firstHit(ray);
                       if (!hit || isBackground)
                       {
                         return !hit && isBackground;
                       }
                       return this->hasSameAnswerNearby(*hit, isShadowed) && !this->isLightInOwnPlane(*hit) &&
                              this->hasSameBlockersNearby(*hit) &&
                              this->hasSameAnswerInDepth(place, ray, *hit, isShadowed);
                     });
}

bool CertainPixels::hasSameAnswerNearby(const truth::Hit& hit, bool isShadowed) const
{
  return std::all_of(this->movedLights.begin(), this->movedLights.end(), [&](const truth::LocalLight& moved)
                     { return this->caster.isReached(hit, moved) != isShadowed; });
}

bool CertainPixels::hasSameBlockersNearby(const truth::Hit& hit) const
{
  const double rounding = this->triangles[hit.triangle].rounding;
  bool same = true;
  for (std::size_t i = 0; i < this->triangles.size(); ++i)
  {
    const truth::LocalTriangle& triangle = this->triangles[i];
    if (i == hit.triangle || !triangle.casts)
    {
      continue;
    }
    const Shadowing shadowing =
        findShadowing(triangle, hit.point, rounding, this->movedLights.front().position, this->halfSide);
    if (shadowing == Shadowing::Always)
    {
      return true;
    }
    same = same && shadowing == Shadowing::Never;
  }
  return same && !this->isLightInPlaneOfBlocker(hit);
}

bool CertainPixels::hasSameAnswerInDepth(const glm::dvec2& at, const truth::Ray& ray, const truth::Hit& hit,
                                         bool isShadowed) const
{
  const truth::LocalTriangle& triangle = this->triangles[hit.triangle];
  const truth::LocalLight& light = this->movedLights.front();
  const glm::dvec3 normal = glm::normalize(glm::cross(triangle.b - triangle.a, triangle.c - triangle.a));
  const glm::dvec3 toLight = glm::normalize(glm::dvec3(light.position) - light.position.w * hit.point);
  const double far =
      getDepthReach(this->rays, {this->getWidth(), this->getHeight()}, at, ray, triangle, hit);
  const double lifted = depthRoundings * far * glm::dot(normal, ray.direction);
  // Where the light's ray through the lifted point meets the surface: a point off the surface would be behind
  // whatever coincides with it.
  const double steepness = glm::dot(normal, toLight);
  const glm::dvec3 along = toLight - steepness * normal;
  for (const double step : {-1.0, -0.5, 0.5, 1.0})
  {
    truth::Hit moved = hit;
    moved.point += step * lifted / steepness * along;
    // Beyond an edge of its own, the volume's side that hangs from there is within rounding of what is seen.
    if (this->caster.isReached(moved, light) == isShadowed || !isInPrism(triangle, moved.point, normal) ||
        this->leavesCoincident(hit, moved.point, std::abs(lifted)))
    {
      return false;
    }
  }
  return true;
}

bool CertainPixels::leavesCoincident(const truth::Hit& hit, const glm::dvec3& moved, double lifted) const
{
  return std::any_of(this->triangles.begin(), this->triangles.end(),
                     [&](const truth::LocalTriangle& other)
                     {
                       const glm::dvec3 normal = glm::cross(other.b - other.a, other.c - other.a);
                       const double height = std::abs(glm::dot(normal, hit.point - other.a));
                       return other.casts && other.index != hit.triangle &&
                              height <= lifted * glm::length(normal) &&
                              isInPrism(other, hit.point, normal) != isInPrism(other, moved, normal);
                     });
}

bool CertainPixels::isLightInOwnPlane(const truth::Hit& hit) const
{
  const truth::LocalTriangle& triangle = this->triangles[hit.triangle];
  return std::any_of(this->movedLights.begin(), this->movedLights.end(),
                     [&](const truth::LocalLight& moved)
                     {
                       const glm::dvec3 direction =
                           glm::dvec3(moved.position) - moved.position.w * hit.point;
                       return isGrazing(triangle, direction) ||
                              truth::sideOfPlane(triangle, moved.position, moved.rounding) == 0;
                     });
}

bool CertainPixels::isLightInPlaneOfBlocker(const truth::Hit& hit) const
{
  for (const truth::LocalTriangle& triangle : this->triangles)
  {
    for (const truth::LocalLight& moved : this->movedLights)
    {
      const glm::dvec3 direction = glm::dvec3(moved.position) - moved.position.w * hit.point;
      if (truth::sideOfPlane(triangle, moved.position, moved.rounding) == 0 &&
          truth::lineVolumes(triangle, hit.point, direction).crosses())
      {
        return true;
      }
    }
  }
  return false;
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
