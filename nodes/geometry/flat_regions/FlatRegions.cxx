#include "FlatRegions.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ExactOrientation.h"
#include "PolygonMerger.h"
#include "TriangleSides.h"

namespace shadow
{

namespace
{

constexpr double radiansPerDegree = 3.14159265358979323846 / 180.0;

std::array<glm::vec3, 3> getOrientedCorners(const SEDGeometry& geometry, std::uint32_t triangle)
{
  const std::array<std::uint32_t, 3>& corners = geometry.getTriangles()[triangle];
  const std::vector<glm::vec3>& positions = geometry.getPositions();
  std::array<glm::vec3, 3> points = {positions[corners[0]], positions[corners[1]], positions[corners[2]]};
  if (geometry.getReversed().test(triangle))
  {
    std::swap(points[1], points[2]);
  }
  return points;
}

glm::dvec3 getNormal(const std::array<glm::vec3, 3>& corners)
{
  const glm::dvec3 origin(corners[0]);
  return glm::cross(glm::dvec3(corners[1]) - origin, glm::dvec3(corners[2]) - origin);
}

int findLargestAxis(const glm::dvec3& v)
{
  const glm::dvec3 size = glm::abs(v);
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

/// Do two triangles lie in one plane and face the same side of it? Exactly.
bool areCoplanar(const std::array<glm::vec3, 3>& a, const std::array<glm::vec3, 3>& b)
{
  for (const glm::vec3& point : b)
  {
    const bool shared = std::find(a.begin(), a.end(), point) != a.end();
    if (!shared && orientation(a[0], a[1], a[2], glm::dvec4(glm::dvec3(point), 1.0)) != 0)
    {
      return false;
    }
  }
  // Their normals are parallel: they agree if a coordinate does that is not zero. The largest one settles it,
  // unless rounding hides it. A triangle without area has none.
  const int largest = findLargestAxis(getNormal(a));
  for (const int axis : {largest, (largest + 1) % 3, (largest + 2) % 3})
  {
    glm::dvec4 direction(0.0);
    direction[axis] = 1.0;
    const int sign = orientation(a[0], a[1], a[2], direction);
    if (sign != 0)
    {
      return sign == orientation(b[0], b[1], b[2], direction);
    }
  }
  return false;
}

double angleBetween(const glm::dvec3& a, const glm::dvec3& b)
{
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Triangles of one region after the other, and of which one each triangle is.
struct Grouping
{
  std::vector<std::uint32_t> regionOf; ///< of each triangle
  std::vector<std::uint32_t> members;  ///< triangles; a region's first one is its representative
  std::vector<std::uint32_t> begins;   ///< of each region, into members; one more at the end
};

/// Grows regions from triangle to triangle.
class RegionGrower
{
public:
  RegionGrower(const SEDGeometry& theGeometry, const std::vector<Edge>& theEdges,
               const TriangleSides& theSides, double toleranceDegrees)
      : geometry(theGeometry), edges(theEdges), sides(theSides),
        tolerance(toleranceDegrees * radiansPerDegree)
  {
  }

  Grouping run()
  {
    const auto count = static_cast<std::uint32_t>(this->sides.size());
    Grouping grouping;
    grouping.regionOf.assign(count, noTriangle);
    grouping.members.reserve(count);
    for (std::uint32_t seed = 0; seed < count; ++seed)
    {
      if (grouping.regionOf[seed] == noTriangle)
      {
        this->grow(seed, grouping);
      }
    }
    grouping.begins.push_back(count);
    return grouping;
  }

private:
  void grow(std::uint32_t seed, Grouping& grouping) const
  {
    const auto region = static_cast<std::uint32_t>(grouping.begins.size());
    grouping.begins.push_back(static_cast<std::uint32_t>(grouping.members.size()));
    grouping.members.push_back(seed);
    grouping.regionOf[seed] = region;
    for (std::size_t next = grouping.begins.back(); next < grouping.members.size(); ++next)
    {
      for (const std::uint32_t side : this->sides[grouping.members[next]])
      {
        const std::uint32_t neighbour = getTriangleAcross(this->edges, side);
        if (neighbour != noTriangle && grouping.regionOf[neighbour] == noTriangle &&
            this->isFlatWith(seed, grouping.members[next], neighbour))
        {
          grouping.regionOf[neighbour] = region;
          grouping.members.push_back(neighbour);
        }
      }
    }
  }

  bool isFlatWith(std::uint32_t seed, std::uint32_t nearest, std::uint32_t triangle) const
  {
    const std::array<glm::vec3, 3> corners = getOrientedCorners(this->geometry, triangle);
    if (this->tolerance <= 0.0)
    {
      // What is exact holds from triangle to triangle, and two that share an edge are told apart at less
      // cost.
      return areCoplanar(getOrientedCorners(this->geometry, nearest), corners);
    }
    const glm::dvec3 a = getNormal(getOrientedCorners(this->geometry, seed));
    const glm::dvec3 b = getNormal(corners);
    return a != glm::dvec3(0.0) && b != glm::dvec3(0.0) && angleBetween(a, b) <= this->tolerance;
  }

  const SEDGeometry& geometry;
  const std::vector<Edge>& edges;
  const TriangleSides& sides;
  double tolerance; ///< radians
};

/// Appends what triangles a polygon is made of. Members follow each other closely, so most share words.
void appendWords(const std::uint32_t* begin, const std::uint32_t* end, std::vector<TriangleWord>& words)
{
  std::vector<std::uint32_t> triangles(begin, end);
  std::sort(triangles.begin(), triangles.end());
  const std::size_t first = words.size();
  for (const std::uint32_t triangle : triangles)
  {
    if (words.size() == first || words.back().word != triangle / 64)
    {
      words.push_back({triangle / 64, 0});
    }
    words.back().mask |= std::uint64_t{1} << (triangle % 64);
  }
}

FlatPolygon appendPolygon(const Grouping& grouping, std::uint32_t region, const PolygonMerger& merger,
                          FlatRegions& regions)
{
  const std::uint32_t begin = grouping.begins[region];
  const std::uint32_t end = grouping.begins[region + 1];
  FlatPolygon polygon{};
  polygon.representative = grouping.members[begin];
  polygon.triangleCount = end - begin;
  polygon.borderBegin = static_cast<std::uint32_t>(regions.border.size());
  polygon.wordsBegin = static_cast<std::uint32_t>(regions.words.size());
  const std::vector<std::array<std::uint32_t, 2>> border = merger.readBorder(polygon.representative);
  regions.border.insert(regions.border.end(), border.begin(), border.end());
  appendWords(grouping.members.data() + begin, grouping.members.data() + end, regions.words);
  polygon.borderEnd = static_cast<std::uint32_t>(regions.border.size());
  polygon.wordsEnd = static_cast<std::uint32_t>(regions.words.size());
  return polygon;
}

} // namespace

std::size_t FlatRegions::getMemorySize() const
{
  return this->polygons.capacity() * sizeof(FlatPolygon) + this->border.capacity() * sizeof(this->border[0]) +
         this->words.capacity() * sizeof(TriangleWord) +
         this->alone.getWords().capacity() * sizeof(std::uint64_t);
}

FlatRegions findFlatRegions(const SEDGeometry& geometry, double toleranceDegrees)
{
  const std::vector<Edge> edges = geometry.getEdges().toVector();
  const TriangleSides sides(edges, geometry.getTriangles().size());
  const Grouping grouping = RegionGrower(geometry, edges, sides, toleranceDegrees).run();
  const auto regionCount = static_cast<std::uint32_t>(grouping.begins.size() - 1);
  FlatRegions regions;
  regions.alone.assign(sides.size());
  for (std::uint32_t region = 0; region < regionCount; ++region)
  {
    if (grouping.begins[region + 1] - grouping.begins[region] == 1)
    {
      regions.alone.set(grouping.members[grouping.begins[region]]);
    }
  }
  if (regionCount == sides.size())
  {
    return regions;
  }

  PolygonMerger merger(edges, sides, geometry.getPositions().size());
  for (std::uint32_t edge = 0; edge < edges.size(); ++edge)
  {
    const auto& [first, second] = edges[edge].triangles;
    if (second != noTriangle && grouping.regionOf[first] == grouping.regionOf[second])
    {
      merger.merge(edge);
    }
  }
  for (std::uint32_t region = 0; region < regionCount; ++region)
  {
    if (grouping.begins[region + 1] - grouping.begins[region] > 1)
    {
      regions.polygons.push_back(appendPolygon(grouping, region, merger, regions));
    }
  }
  return regions;
}

} // namespace shadow
