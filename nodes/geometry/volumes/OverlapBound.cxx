#include "OverlapBound.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "SEDGeometry.h"
#include "ShadowVolume.h"

namespace shadow
{

namespace
{

/// Below this, relative to the coordinates it comes from, a difference may be rounding.
constexpr double tolerance = 1e-12;

/// Three perpendicular unit vectors, right-handed.
struct Frame
{
  glm::dvec3 right;
  glm::dvec3 up;
  glm::dvec3 pole;
};

Frame makeFrame(const glm::dvec3& pole)
{
  Frame frame;
  frame.pole = glm::normalize(pole);
  const glm::dvec3 helper = std::abs(frame.pole.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  frame.right = glm::normalize(glm::cross(frame.pole, helper));
  frame.up = glm::cross(frame.pole, frame.right);
  return frame;
}

/// Adds up, along a line or a circle, how many intervals lie over a place.
class Sweep
{
public:
  explicit Sweep(std::size_t intervals) { this->events.reserve(2 * intervals); }

  void add(double begin, double end, std::uint32_t multiplicity)
  {
    this->events.emplace_back(begin, static_cast<std::int64_t>(multiplicity));
    this->events.emplace_back(end, -static_cast<std::int64_t>(multiplicity));
  }

  void addEverywhere(std::uint32_t multiplicity) { this->everywhere += multiplicity; }

  /// Intervals are open at one end: the edges of a loop take turns at the vertices between them.
  std::size_t findMost()
  {
    std::sort(this->events.begin(), this->events.end());
    std::int64_t over = 0;
    std::int64_t most = 0;
    for (std::size_t index = 0; index < this->events.size(); ++index)
    {
      over += this->events[index].second;
      if (index + 1 == this->events.size() || this->events[index + 1].first != this->events[index].first)
      {
        most = std::max(most, over);
      }
    }
    return static_cast<std::size_t>(most) + this->everywhere;
  }

private:
  std::vector<std::pair<double, std::int64_t>> events;
  std::size_t everywhere = 0;
};

/// A full turn is 4; rises with the angle, is exactly antisymmetric, and costs one division.
double turnOf(double x, double y)
{
  const double ratio = y / (std::abs(x) + std::abs(y));
  return x < 0.0 ? 2.0 - ratio : ratio < 0.0 ? 4.0 + ratio : ratio;
}

bool casts(const LightFacing& facing, Casting casting, std::size_t triangle)
{
  return facing.towards.test(triangle) || (casting == Casting::EveryTriangle && facing.away.test(triangle));
}

/// All rays are parallel: walk across their direction, in from where nothing is hit. Going one way only edges
/// that run to the right lead into the volume.
std::size_t boundParallel(const SEDGeometry& geometry, const std::vector<SilhouetteEdge>& silhouette,
                          const glm::dvec3& directionMC)
{
  const Frame frame = makeFrame(directionMC);
  Sweep sweep(silhouette.size());
  for (const SilhouetteEdge& edge : silhouette)
  {
    const double begin = glm::dot(frame.right, glm::dvec3(geometry.getPositions()[edge.from]));
    const double end = glm::dot(frame.right, glm::dvec3(geometry.getPositions()[edge.to]));
    if (begin < end)
    {
      sweep.add(begin, end, edge.multiplicity);
    }
  }
  return sweep.findMost();
}

/// How many casting triangles the ray from the light to the frame's pole hits, or may hit but for rounding.
std::size_t countAlongPole(const SEDGeometry& geometry, const LightFacing& facing, Casting casting,
                           const glm::dvec3& lightMC, const Frame& frame, double margin)
{
  std::size_t count = 0;
  for (std::size_t triangle = 0; triangle < geometry.getTriangles().size(); ++triangle)
  {
    if (!casts(facing, casting, triangle))
    {
      continue;
    }
    std::array<glm::dvec2, 3> corners;
    double height = -1.0;
    for (int corner = 0; corner < 3; ++corner)
    {
      const std::uint32_t vertex = geometry.getTriangles()[triangle][corner];
      const glm::dvec3 arm = glm::dvec3(geometry.getPositions()[vertex]) - lightMC;
      corners[corner] = {glm::dot(arm, frame.right), glm::dot(arm, frame.up)};
      height = std::max(height, glm::dot(arm, frame.pole) + margin);
    }
    bool left = true;
    bool right = true;
    for (int corner = 0; corner < 3; ++corner)
    {
      const glm::dvec2& a = corners[corner];
      const glm::dvec2& b = corners[(corner + 1) % 3];
      const double area = a.x * b.y - a.y * b.x;
      const double slack = margin * (glm::length(a) + glm::length(b) + margin);
      left = left && area >= -slack;
      right = right && area <= slack;
    }
    count += (left || right) && height >= 0.0 ? 1 : 0;
  }
  return count;
}

/// All rays leave one point: walk from a pole along meridians. Seen from the light, what lies south of an
/// edge that runs east is on its left and thus casts: these edges lead in, those that run west lead out.
std::size_t boundMeridians(const SEDGeometry& geometry, const std::vector<SilhouetteEdge>& silhouette,
                           const glm::dvec3& lightMC, const Frame& frame, double margin)
{
  Sweep sweep(silhouette.size());
  const auto project = [&](std::uint32_t vertex)
  {
    const glm::dvec3 arm = glm::dvec3(geometry.getPositions()[vertex]) - lightMC;
    return glm::dvec2(glm::dot(arm, frame.right), glm::dot(arm, frame.up));
  };
  for (const SilhouetteEdge& edge : silhouette)
  {
    const glm::dvec2 from = project(edge.from);
    const glm::dvec2 to = project(edge.to);
    const bool nearAxis = glm::length(from) <= margin || glm::length(to) <= margin;
    const double begin = nearAxis ? 0.0 : turnOf(from.x, from.y);
    const double end = nearAxis ? 0.0 : turnOf(to.x, to.y);
    const double eastwards = end >= begin ? end - begin : end - begin + 4.0;
    // An edge through the axis may pass it on either side.
    if (nearAxis || std::abs(eastwards - 2.0) < 1e-9)
    {
      sweep.addEverywhere(edge.multiplicity);
    }
    else if (eastwards > 0.0 && eastwards < 2.0)
    {
      if (begin < end)
      {
        sweep.add(begin, end, edge.multiplicity);
      }
      else
      {
        sweep.add(begin, 4.0, edge.multiplicity);
        sweep.add(0.0, end, edge.multiplicity);
      }
    }
  }
  return sweep.findMost();
}

} // namespace

std::size_t countCasting(const LightFacing& facing, Casting casting)
{
  const std::size_t towards = facing.towards.countSet();
  return casting == Casting::LightFacing ? towards : towards + facing.away.countSet();
}

std::size_t boundOverlap(const SEDGeometry& geometry, const std::vector<SilhouetteEdge>& silhouette,
                         const LightFacing& facing, Casting casting, const glm::dvec4& lightMC)
{
  const std::size_t most = countCasting(facing, casting);
  const glm::dvec3 light(lightMC);
  if (most == 0 || !(glm::length(light) > 0.0 || lightMC.w != 0.0))
  {
    return most;
  }
  if (lightMC.w == 0.0)
  {
    return std::min(most, boundParallel(geometry, silhouette, light));
  }

  const glm::dvec3 centre = 0.5 * (geometry.getLowerBound() + geometry.getUpperBound());
  const double radius = 0.5 * glm::length(geometry.getUpperBound() - geometry.getLowerBound());
  const glm::dvec3 away = light - centre;
  const double distance = glm::length(away);
  // Tilted, so that the axis does not run through the vertices of symmetric meshes.
  const glm::dvec3 tilt = 0.1 * std::max(distance, 0.1 * radius) * glm::dvec3(0.6180, 0.4142, 0.7321);
  const Frame frame = makeFrame(away + tilt);
  const double margin = tolerance * (distance + radius);
  std::size_t atPole = 0;
  if (distance <= radius * (1.0 + 1e-6))
  {
    atPole = countAlongPole(geometry, facing, casting, light, frame, margin);
  }
  return std::min(most, atPole + boundMeridians(geometry, silhouette, light, frame, margin));
}

} // namespace shadow
