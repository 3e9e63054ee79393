#include "OutlineEdges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>

#include "TriangleTests.h"
#include "TruthBvh.h"

namespace shadow::truth
{

namespace
{

/// What a vertex may be off when its mesh is kept in single precision, relative to the mesh's coordinates.
constexpr double floatRounding = 1.2e-7;

/// How far corners may lie apart to count as one, relative to the size of their part: two roundings of single
/// precision, which is what the ends of a closed curve may miss one another by.
constexpr double placeRounding = 2.4e-7;

/// Degrees within which an angle counts as the limit.
constexpr double angleRounding = 1e-3;

/// A side of a triangle, its ends sorted.
struct Side
{
  std::uint32_t low, high; ///< vertices
  std::uint32_t triangle;
};

bool isFinite(const Triangle& triangle)
{
  const glm::dvec3 sum = glm::abs(triangle.a) + glm::abs(triangle.b) + glm::abs(triangle.c);
  return std::isfinite(sum.x + sum.y + sum.z);
}

/// Corners of one part that are closer than rounding of a mesh as large as the part count as one place.
class PlaceTable
{
public:
  explicit PlaceTable(double size) : tolerance(placeRounding * size) {}

  /// The number of a place within the tolerance that is known already; else of a new one.
  std::uint32_t find(const glm::dvec3& point, std::uint32_t next)
  {
    for (double x = this->cellOf(point.x - this->tolerance); x <= this->cellOf(point.x + this->tolerance);
         ++x)
    {
      for (double y = this->cellOf(point.y - this->tolerance); y <= this->cellOf(point.y + this->tolerance);
           ++y)
      {
        for (double z = this->cellOf(point.z - this->tolerance); z <= this->cellOf(point.z + this->tolerance);
             ++z)
        {
          const auto [first, last] = this->places.equal_range({x, y, z});
          for (auto place = first; place != last; ++place)
          {
            if (glm::distance(place->second.first, point) <= this->tolerance)
            {
              return place->second.second;
            }
          }
        }
      }
    }
    this->places.insert(
        {{this->cellOf(point.x), this->cellOf(point.y), this->cellOf(point.z)}, {point, next}});
    return next;
  }

private:
  double cellOf(double coordinate) const
  {
    return this->tolerance > 0.0 ? std::floor(coordinate / (4.0 * this->tolerance)) : coordinate;
  }

  double tolerance;
  std::multimap<std::array<double, 3>, std::pair<glm::dvec3, std::uint32_t>> places;
};

const glm::dvec3& cornerOf(const Scene& scene, std::uint32_t corner)
{
  const Triangle& triangle = scene.triangles[corner / 3];
  return corner % 3 == 0 ? triangle.a : corner % 3 == 1 ? triangle.b : triangle.c;
}

/// Numbers the corners of the triangles [first, last), which are one part.
void numberPart(const Scene& scene, std::uint32_t first, std::uint32_t last, std::uint32_t& next,
                std::vector<std::uint32_t>& numbers)
{
  Box bounds;
  for (std::uint32_t corner = 3 * first; corner < 3 * last; ++corner)
  {
    if (isFinite(scene.triangles[corner / 3]))
    {
      bounds.add(cornerOf(scene, corner));
    }
  }
  PlaceTable places(glm::length(bounds.high - bounds.low));
  for (std::uint32_t corner = 3 * first; corner < 3 * last; ++corner)
  {
    if (isFinite(scene.triangles[corner / 3]))
    {
      numbers[corner] = places.find(cornerOf(scene, corner), next);
      next += numbers[corner] == next ? 1 : 0;
    }
  }
}

/// A number for each corner, the same for those of one part at one place.
std::vector<std::uint32_t> numberCorners(const Scene& scene)
{
  std::vector<std::uint32_t> numbers(3 * scene.triangles.size(), 0);
  std::uint32_t next = 0;
  for (std::uint32_t first = 0; first < scene.triangles.size();)
  {
    std::uint32_t last = first + 1;
    while (last < scene.triangles.size() && scene.triangles[last].part == scene.triangles[first].part)
    {
      ++last;
    }
    numberPart(scene, first, last, next, numbers);
    first = last;
  }
  return numbers;
}

std::vector<Side> sortSides(const Scene& scene, const std::vector<std::uint32_t>& numbers)
{
  std::vector<Side> sides;
  for (std::uint32_t triangle = 0; triangle < scene.triangles.size(); ++triangle)
  {
    const std::uint32_t* v = &numbers[3 * triangle];
    if (isFinite(scene.triangles[triangle]) && v[0] != v[1] && v[1] != v[2] && v[2] != v[0])
    {
      for (std::uint32_t side = 0; side < 3; ++side)
      {
        const auto [low, high] = std::minmax(v[side], v[(side + 1) % 3]);
        sides.push_back({low, high, triangle});
      }
    }
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& left, const Side& right) {
              return std::tie(left.low, left.high, left.triangle) <
                     std::tie(right.low, right.high, right.triangle);
            });
  return sides;
}

/// Decides which edges are shown.
class EdgeJudge
{
public:
  EdgeJudge(const Scene& theScene, const PixelRays& rays, const glm::dvec3& theOrigin,
            const std::optional<double>& crease)
      : scene(theScene), eye(rays.eye()), origin(theOrigin), creaseDegrees(crease)
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
    this->rounding = floatRounding * glm::length(bounds.high - bounds.low);
  }

  /// Adds the edge of the sides [first, last) if it may be shown.
  void judge(const std::vector<std::uint32_t>& numbers, const Side* first, const Side* last,
             std::vector<OutlineEdge>& edges) const;

private:
  /// The triangle of a side, begun with the edge's lower vertex, then its higher one.
  LocalTriangle turn(const std::vector<std::uint32_t>& numbers, const Side& side) const
  {
    std::array<glm::dvec3, 3> corners;
    const Triangle& triangle = this->scene.triangles[side.triangle];
    const std::array<glm::dvec3, 3> given = {triangle.a, triangle.b, triangle.c};
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::uint32_t number = numbers[3 * side.triangle + i];
      corners[number == side.low ? 0 : number == side.high ? 1 : 2] = given[i] - this->origin;
    }
    return {corners[0], corners[1], corners[2], this->rounding, side.triangle, true, false, false};
  }

  const Scene& scene;
  glm::dvec4 eye;
  glm::dvec3 origin;
  double rounding;
  std::optional<double> creaseDegrees;
};

/// Yes, no, or a matter of rounding.
enum class Shown
{
  No,
  Perhaps,
  Yes
};

Shown isCrease(const LocalTriangle& one, const LocalTriangle& other, double limit)
{
  // Both begin with the edge, so neighbours that go on flat have opposite normals here.
  const glm::dvec3 normal = glm::cross(one.b - one.a, one.c - one.a);
  const glm::dvec3 otherNormal = -glm::cross(other.b - other.a, other.c - other.a);
  const double degrees =
      glm::degrees(std::atan2(glm::length(glm::cross(normal, otherNormal)), glm::dot(normal, otherNormal)));
  return degrees > limit + angleRounding   ? Shown::Yes
         : degrees < limit - angleRounding ? Shown::No
                                           : Shown::Perhaps;
}

/// Where the triangles of an edge lie, seen from the eye.
struct Balance
{
  std::ptrdiff_t sides = 0;
  std::ptrdiff_t left = 0;
  std::ptrdiff_t right = 0;

  void add(int towards)
  {
    this->sides += 1;
    this->left += towards > 0 ? 1 : 0;
    this->right += towards < 0 ? 1 : 0;
  }

  Shown isOutline() const
  {
    const bool isBorder = this->sides == 1;
    const bool isDoubtful = !isBorder && (this->left + this->right < this->sides ||
                                          (this->left == this->right && this->left > 1));
    return isDoubtful                              ? Shown::Perhaps
           : isBorder || this->left != this->right ? Shown::Yes
                                                   : Shown::No;
  }
};

void EdgeJudge::judge(const std::vector<std::uint32_t>& numbers, const Side* first, const Side* last,
                      std::vector<OutlineEdge>& edges) const
{
  const LocalTriangle one = this->turn(numbers, *first);
  // Of triangles with the same third corner all but the first are copies.
  std::vector<std::uint32_t> thirds;
  const Side* second = nullptr;
  Balance all;
  Balance once;
  for (const Side* side = first; side < last; ++side)
  {
    const int towards = sideOfPlane(this->turn(numbers, *side), this->eye, this->rounding);
    const std::uint32_t* v = &numbers[3 * side->triangle];
    const std::uint32_t third = v[0] ^ v[1] ^ v[2] ^ side->low ^ side->high;
    all.add(towards);
    if (std::find(thirds.begin(), thirds.end(), third) == thirds.end())
    {
      thirds.push_back(third);
      once.add(towards);
      second = once.sides == 2 ? side : second;
    }
  }
  Shown shown = once.isOutline();
  if (once.sides > 2 && all.isOutline() != shown)
  {
    shown = Shown::Perhaps; // the copies may be a wall between solids, each of which has its own
  }
  OutlineEdge edge{one.a, one.b, {one.index, noNeighbour}, true, 0};
  edge.inside = all.left > 0 && all.right > 0 ? 0 : all.left > 0 ? 1 : all.right > 0 ? -1 : 0;
  if (once.sides == 2)
  {
    edge.triangles[1] = second->triangle;
    if (this->creaseDegrees)
    {
      shown = std::max(shown, isCrease(one, this->turn(numbers, *second), *this->creaseDegrees));
    }
  }
  if (shown != Shown::No)
  {
    edge.certain = shown == Shown::Yes;
    edges.push_back(edge);
  }
}

} // namespace

std::vector<OutlineEdge> findOutlineEdges(const Scene& scene, const PixelRays& rays,
                                          const glm::dvec3& originWC,
                                          const std::optional<double>& creaseDegrees)
{
  const std::vector<std::uint32_t> numbers = numberCorners(scene);
  const std::vector<Side> sides = sortSides(scene, numbers);
  const EdgeJudge judge(scene, rays, originWC, creaseDegrees);
  std::vector<OutlineEdge> edges;
  for (std::size_t i = 0; i < sides.size();)
  {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high)
    {
      ++end;
    }
    judge.judge(numbers, &sides[i], sides.data() + end, edges);
    i = end;
  }
  return edges;
}

} // namespace shadow::truth
