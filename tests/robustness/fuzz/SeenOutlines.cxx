#include "SeenOutlines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace shadow::fuzz
{

namespace
{

constexpr double grid = 1.0 / 256;
constexpr double roundings = 4.0 * std::numeric_limits<float>::epsilon();
constexpr double depthStep = 1.0 / (1 << 21); // a depth buffer of 24 bits
constexpr std::size_t nearPlaneSide = 3;

std::array<glm::dvec3, 3> getCorners(const truth::LocalTriangle& triangle)
{
  return {triangle.a, triangle.b, triangle.c};
}

/// The corner of the other triangle that is not on the edge; none: it has not got the edge.
std::optional<glm::dvec3> findThirdCorner(const truth::LocalTriangle& triangle, const glm::dvec3& from,
                                          const glm::dvec3& to)
{
  const std::array<glm::dvec3, 3> corners = getCorners(triangle);
  for (std::size_t i = 0; i < 3; ++i)
  {
    const glm::dvec3& start = corners[i];
    const glm::dvec3& end = corners[(i + 1) % 3];
    if ((start == from && end == to) || (start == to && end == from))
    {
      return corners[(i + 2) % 3];
    }
  }
  return std::nullopt;
}

/// Whether an edge is between two points as seen from a place: a position (w = 1) or a direction (w = 0).
bool isBetween(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& one, const glm::dvec3& other,
               const glm::dvec4& place)
{
  const glm::dvec3 normal = glm::cross(to - from, glm::dvec3(place) - place.w * from);
  return glm::dot(normal, one - from) * glm::dot(normal, other - from) < 0.0;
}

} // namespace

/// An edge, as far as it is in front of the near plane; or what that plane cuts.
struct SeenOutlines::Side
{
  glm::dvec3 from, to;
  std::size_t index; ///< from corner a, b or c; else nearPlaneSide
};

SeenOutlines::SeenOutlines(const std::vector<truth::LocalTriangle>& all, const truth::PixelRays& view,
                           const glm::dvec4& light)
    : triangles(all), rays(view), lightPosition(light)
{
}

bool SeenOutlines::pass(const glm::dvec2& at, const std::optional<truth::Hit>& hit) const
{
  for (std::size_t i = 0; i < this->triangles.size(); ++i)
  {
    double hiddenBehind = std::numeric_limits<double>::infinity();
    if (hit && hit->triangle != i)
    {
      const glm::dvec4 clip = this->rays.toClip(hit->point);
      hiddenBehind = clip.z / clip.w + depthStep;
    }
    int count = 0;
    bool ends = false;
    for (const Side& side : this->getSeenSides(this->triangles[i]))
    {
      if (this->isNear(side, at, hiddenBehind))
      {
        ++count;
        ends = ends || !this->goesOn(this->triangles[i], side.index);
      }
    }
    // By two of its edges: a corner, or a triangle thinner than the grid.
    if (ends || count > 1)
    {
      return true;
    }
  }
  return false;
}

bool SeenOutlines::passThinVolume(const glm::dvec2& at) const
{
  return std::any_of(this->triangles.begin(), this->triangles.end(),
                     [&](const truth::LocalTriangle& triangle)
                     {
                       if (!triangle.casts)
                       {
                         return false;
                       }
                       bool isThin = true;
                       bool endsThin = true;
                       const std::array<glm::dvec3, 3> corners = getCorners(triangle);
                       for (std::size_t i = 0; i < 3; ++i)
                       {
                         const glm::dvec4 from = this->getRay(corners[i]);
                         isThin = isThin && this->isNearLine({corners[i], 1.0}, from, at);
                         const glm::dvec4 to = this->getRay(corners[(i + 1) % 3]);
                         endsThin = endsThin && this->isNearLine(from, to, at);
                       }
                       return isThin || endsThin;
                     });
}

/// Direction from the light.
glm::dvec4 SeenOutlines::getRay(const glm::dvec3& point) const
{
  return {this->lightPosition.w * point - glm::dvec3(this->lightPosition), 0.0};
}

/// On the screen, and on without end; each a position (w = 1) or a direction (w = 0). Equal ones are no line.
bool SeenOutlines::isNearLine(const glm::dvec4& from, const glm::dvec4& to, const glm::dvec2& at) const
{
  const glm::dvec4 origin = this->rays.toClip(glm::dvec3(0.0));
  const auto toScreen = [&](const glm::dvec4& place)
  {
    const glm::dvec4 clip = this->rays.toClip(glm::dvec3(place)) - (1.0 - place.w) * origin;
    return glm::dvec3(clip.x, clip.y, clip.w);
  };
  const glm::dvec2 zero = this->rays.toPixels({0.0, 0.0, 0.0, 1.0});
  const glm::dvec2 pixels = this->rays.toPixels({1.0, 1.0, 0.0, 1.0}) - zero;
  const glm::dvec3 line = glm::cross(toScreen(from), toScreen(to));
  return std::abs(glm::dot(line, glm::dvec3((at - zero) / pixels, 1.0))) <
         grid * glm::length(glm::dvec2(line) / pixels);
}

std::vector<SeenOutlines::Side> SeenOutlines::getSeenSides(const truth::LocalTriangle& triangle) const
{
  const std::array<glm::dvec3, 3> corners = getCorners(triangle);
  std::array<double, 3> heights{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    heights[i] = this->rays.toClip(corners[i]).z;
  }
  std::vector<Side> sides;
  std::vector<glm::dvec3> cuts;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t next = (i + 1) % 3;
    Side side = {corners[i], corners[next], i};
    const bool starts = heights[i] > 0.0;
    const bool ends = heights[next] > 0.0;
    if (starts != ends)
    {
      cuts.push_back(glm::mix(side.from, side.to, heights[i] / (heights[i] - heights[next])));
      (starts ? side.to : side.from) = cuts.back();
    }
    if (starts || ends)
    {
      sides.push_back(side);
    }
  }
  if (cuts.size() == 2)
  {
    sides.push_back({cuts[0], cuts[1], nearPlaneSide});
  }
  return sides;
}

bool SeenOutlines::isNear(const Side& side, const glm::dvec2& at, double hiddenBehind) const
{
  const glm::dvec4 fromClip = this->rays.toClip(side.from);
  const glm::dvec4 toClip = this->rays.toClip(side.to);
  const glm::dvec2 from = this->rays.toPixels(fromClip);
  const glm::dvec2 along = this->rays.toPixels(toClip) - from;
  const double length2 = glm::dot(along, along);
  const double place = length2 > 0.0 ? glm::clamp(glm::dot(at - from, along) / length2, 0.0, 1.0) : 0.0;
  const double depth = glm::mix(fromClip.z / fromClip.w, toClip.z / toClip.w, place);
  const double distance = glm::distance(at, from + place * along);
  return depth <= hiddenBehind &&
         distance <= grid + glm::mix(this->getRounding(side.from), this->getRounding(side.to), place);
}

/// Pixels by which single precision may move the point: each coordinate in clip space is a sum, and rounded
/// as its terms are.
double SeenOutlines::getRounding(const glm::dvec3& point) const
{
  const glm::dvec4 origin = this->rays.toClip(glm::dvec3(0.0));
  glm::dvec4 terms = glm::abs(origin);
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec3 part(0.0);
    part[axis] = point[axis];
    terms += glm::abs(this->rays.toClip(part) - origin);
  }
  const glm::dvec4 clip = this->rays.toClip(point);
  const glm::dvec2 pixels =
      this->rays.toPixels({1.0, 1.0, 0.0, 1.0}) - this->rays.toPixels({0.0, 0.0, 0.0, 1.0});
  const glm::dvec2 moved = (glm::dvec2(terms) + glm::abs(glm::dvec2(clip) / clip.w) * terms.w) / clip.w;
  return roundings * glm::length(pixels * moved);
}

bool SeenOutlines::goesOn(const truth::LocalTriangle& triangle, std::size_t side) const
{
  if (side == nearPlaneSide)
  {
    return false;
  }
  const std::array<glm::dvec3, 3> corners = getCorners(triangle);
  const glm::dvec3& from = corners[side];
  const glm::dvec3& to = corners[(side + 1) % 3];
  const glm::dvec3& own = corners[(side + 2) % 3];
  int others = 0;
  for (const truth::LocalTriangle& other : this->triangles)
  {
    const std::optional<glm::dvec3> third =
        &other == &triangle ? std::nullopt : findThirdCorner(other, from, to);
    if (third && (!isBetween(from, to, own, *third, this->rays.eye()) ||
                  !isBetween(from, to, own, *third, this->lightPosition)))
    {
      return false;
    }
    others += third ? 1 : 0;
  }
  return others == 1;
}

} // namespace shadow::fuzz
