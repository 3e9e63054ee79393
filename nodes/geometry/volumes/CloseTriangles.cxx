#include "CloseTriangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ExactOrientation.h"

namespace shadow
{

namespace
{

/// How far outside the bounding box, and how far off the plane of a triangle, a light can be and yet be close:
/// generous shares of the box's diagonal.
constexpr double reachOfBox = 0.05;

/// Rays are opposite where one plus the cosine between them is below this. A triangle with such an edge has a
/// volume below 0.009 and a sum below 0.01, see isClose().
constexpr double oppositeBelow = 4e-5;

using Rays = std::array<glm::dvec3, 3>;

Rays raysThroughCorners(const SEDGeometry& geometry, std::uint32_t triangle, const glm::dvec3& lightMC)
{
  Rays rays;
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    const std::uint32_t vertex = geometry.getTriangles()[triangle][corner];
    rays[corner] = glm::dvec3(geometry.getPositions()[vertex]) - lightMC;
  }
  return rays;
}

/// Whether the solid angle of the triangle is about half of the sphere or more, or one of its edges passes the
/// light, while the rays through its corners span next to no volume.
///
/// @par Source  Van Oosterom & Strackee 1983, "The Solid Angle of a Plane Triangle": the angle's tangent is
///              the volume over the sum below
bool isClose(const Rays& rays)
{
  const double a = glm::length(rays[0]);
  const double b = glm::length(rays[1]);
  const double c = glm::length(rays[2]);
  const double volume = glm::dot(rays[0], glm::cross(rays[1], rays[2]));
  const double sum = a * b * c + glm::dot(rays[0], rays[1]) * c + glm::dot(rays[1], rays[2]) * a +
                     glm::dot(rays[2], rays[0]) * b;
  return std::abs(volume) < 0.01 * a * b * c && sum < 0.05 * a * b * c;
}

} // namespace

bool mayHaveCloseTriangles(const SEDGeometry& geometry, const glm::dvec4& lightMC)
{
  const glm::dvec3 margin(reachOfBox * glm::length(geometry.getUpperBound() - geometry.getLowerBound()));
  return lightMC.w != 0.0 &&
         glm::all(glm::greaterThanEqual(glm::dvec3(lightMC), geometry.getLowerBound() - margin)) &&
         glm::all(glm::lessThanEqual(glm::dvec3(lightMC), geometry.getUpperBound() + margin));
}

std::vector<std::uint32_t> findCloseTriangles(const SEDGeometry& geometry, const LightFacing& facing,
                                              Casting casting, const glm::dvec4& lightMC)
{
  std::vector<std::uint32_t> close;
  if (!mayHaveCloseTriangles(geometry, lightMC))
  {
    return close;
  }
  const glm::dvec4 inReach(glm::dvec3(lightMC), geometry.getReach());
  const double farthest = reachOfBox * glm::length(geometry.getUpperBound() - geometry.getLowerBound());
  for (std::size_t word = 0; word < facing.towards.getWords().size(); ++word)
  {
    std::uint64_t casts = facing.towards.getWords()[word];
    casts |= casting == Casting::EveryTriangle ? facing.away.getWords()[word] : 0;
    for (; casts != 0; casts &= casts - 1)
    {
      const std::size_t bit = findLowestBit(casts);
      const auto triangle = static_cast<std::uint32_t>(64 * word + bit);
      // Normals are of unit length, up to rounding, or zero, which decides nothing.
      const bool nearPlane = std::abs(glm::dot(geometry.getPlaneBlocks()[word].get(bit), inReach)) < farthest;
      if (nearPlane && isClose(raysThroughCorners(geometry, triangle, glm::dvec3(lightMC))))
      {
        close.push_back(triangle);
      }
    }
  }
  return close;
}

glm::dvec3 ClosePartBuilder::getRay(std::uint32_t vertex) const
{
  return glm::dvec3(this->geometry.getPositions()[vertex]) - this->lightMC;
}

std::uint32_t ClosePartBuilder::addCopy(std::uint32_t vertex, bool isFar)
{
  this->part.vertices.emplace_back(this->geometry.getPositions()[vertex], isFar ? 0.0f : 1.0f);
  return static_cast<std::uint32_t>(this->part.vertices.size() - 1);
}

std::uint32_t ClosePartBuilder::addRay(const glm::dvec3& ray)
{
  this->part.vertices.emplace_back(glm::vec3(glm::normalize(ray)), -1.0f);
  return static_cast<std::uint32_t>(this->part.vertices.size() - 1);
}

/// Through the point of an edge next to the light: across the edge, in the plane that both lie in. The same for
/// both triangles of the edge. On whose side of the light the edge is has to agree with their facing, however
/// close it is: else their volumes would be turned over.
std::uint32_t ClosePartBuilder::addRayBetween(std::uint32_t from, std::uint32_t to)
{
  const glm::vec3& first = this->geometry.getPositions()[std::min(from, to)];
  const glm::vec3& second = this->geometry.getPositions()[std::max(from, to)];
  return this->addRay(
      glm::cross(glm::dvec3(second) - glm::dvec3(first), exactCross(first, second, this->lightMC)));
}

bool ClosePartBuilder::passesLight(std::uint32_t from, std::uint32_t to) const
{
  const glm::dvec3 first = this->getRay(from);
  const glm::dvec3 second = this->getRay(to);
  return glm::dot(first, second) < (oppositeBelow - 1.0) * glm::length(first) * glm::length(second);
}

void ClosePartBuilder::addSide(const SilhouetteEdge& edge)
{
  const std::uint32_t from = this->addCopy(edge.from, false);
  const std::uint32_t to = this->addCopy(edge.to, false);
  const std::uint32_t farFrom = this->addCopy(edge.from, true);
  const std::uint32_t farTo = this->addCopy(edge.to, true);
  const std::uint32_t between = this->addRayBetween(edge.from, edge.to);
  std::vector<ShadowVolume::Triangle>& sides =
      edge.multiplicity == 2 ? this->part.doubledSides : this->part.sides;
  sides.push_back({to, from, farFrom});
  sides.push_back({to, farFrom, between});
  sides.push_back({to, between, farTo});
}

void ClosePartBuilder::addDarkFan(std::uint32_t triangle, bool turned)
{
  std::array<std::uint32_t, 3> corners = this->geometry.getTriangles()[triangle];
  if (this->geometry.getReversed().test(triangle) != turned)
  {
    std::swap(corners[1], corners[2]);
  }
  // Counter-clockwise seen from the light now, so that this looks away from it.
  const glm::dvec3 a = this->getRay(corners[0]);
  const std::uint32_t apex =
      this->addRay(-glm::cross(this->getRay(corners[1]) - a, this->getRay(corners[2]) - a));
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    const std::uint32_t from = corners[corner];
    const std::uint32_t to = corners[(corner + 1) % 3];
    const std::uint32_t farFrom = this->addCopy(from, true);
    const std::uint32_t farTo = this->addCopy(to, true);
    if (this->passesLight(from, to))
    {
      const std::uint32_t between = this->addRayBetween(from, to);
      this->part.darkCap.push_back({apex, between, farFrom});
      this->part.darkCap.push_back({apex, farTo, between});
    }
    else
    {
      this->part.darkCap.push_back({apex, farTo, farFrom});
    }
  }
}

} // namespace shadow
