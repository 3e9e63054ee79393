// The last stages of SEDGeometryBuilder: what is computed once the triangles are connected and oriented.
#include "SEDGeometryBuilder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <utility>

#include "Revision.h"

namespace shadow
{

namespace
{

double largestMagnitude(const glm::dvec3& v)
{
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

glm::dvec3 edgeOf(const std::vector<glm::vec3>& positions, std::uint32_t from, std::uint32_t to)
{
  return glm::dvec3(positions[to]) - glm::dvec3(positions[from]);
}

bool comesBefore(const glm::vec3& a, const glm::vec3& b)
{
  return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

} // namespace

void SEDGeometryBuilder::countEdgesAndBounds()
{
  this->geometry.report.borderEdges = static_cast<std::size_t>(
      std::count_if(this->edges.begin(), this->edges.end(),
                    [](const Edge& edge) { return edge.triangles[1] == noTriangle; }));
  for (const glm::vec3& position : this->geometry.positions)
  {
    this->geometry.lowerBound = glm::min(this->geometry.lowerBound, glm::dvec3(position));
    this->geometry.upperBound = glm::max(this->geometry.upperBound, glm::dvec3(position));
  }
  this->geometry.positions.shrink_to_fit();
  const glm::dvec3 farthest =
      glm::max(glm::abs(this->geometry.lowerBound), glm::abs(this->geometry.upperBound));
  int exponent = 0;
  std::frexp(farthest.x + farthest.y + farthest.z, &exponent);
  this->geometry.reach = std::ldexp(1.0, exponent);
}

void SEDGeometryBuilder::computePlanes()
{
  const auto count = static_cast<std::uint32_t>(this->geometry.triangles.size());
  this->geometry.planeBlocks.resize((count + PlaneBlock::triangles - 1) / PlaneBlock::triangles);
  this->geometry.reversed.assign(count);
  this->geometry.inputReversed.assign(count);
  constexpr std::size_t grain = 256 * PlaneBlock::triangles; // no two threads write bits of one word
  std::mutex totalling;
  forRanges(this->options.parallelFor, count, grain,
            [&](std::size_t begin, std::size_t end)
            {
              PlaneTotals totals;
              for (std::size_t triangle = begin; triangle < end; ++triangle)
              {
                this->finishTriangle(static_cast<std::uint32_t>(triangle), totals);
              }
              const std::lock_guard<std::mutex> lock(totalling);
              this->geometry.report.zeroAreaTriangles += totals.zeroArea;
              this->geometry.sharpness = std::max(this->geometry.sharpness, totals.sharpness);
            });
}

/// Raster order and plane.
void SEDGeometryBuilder::finishTriangle(std::uint32_t triangle, PlaneTotals& totals)
{
  std::array<std::uint32_t, 3>& corners = this->geometry.triangles[triangle];
  const std::vector<glm::vec3>& positions = this->geometry.positions;
  bool odd = false;
  for (const auto& [first, second] : {std::pair(0, 1), std::pair(1, 2), std::pair(0, 1)})
  {
    if (comesBefore(positions[corners[second]], positions[corners[first]]))
    {
      std::swap(corners[first], corners[second]);
      odd = !odd;
    }
  }
  if (odd)
  {
    this->geometry.reversed.set(triangle);
  }
  if (odd != (this->flipped[triangle] != 0))
  {
    this->geometry.inputReversed.set(triangle);
  }

  const TrianglePlane plane = this->geometry.getPlane(triangle);
  const double largest = largestMagnitude(plane.normal);
  if (largest == 0.0)
  {
    ++totals.zeroArea;
    return;
  }
  // With eps = 2^-53 and P the largest |u.i v.j| + |u.j v.i|: a normal's coordinate is off by 4 eps P, the
  // offset by 7 eps P |p|. Both stay below a third of a unit of single precision where P is not much larger
  // than the normal. A needle, where it is, keeps a plane of zeros.
  const glm::dvec3 u = edgeOf(positions, corners[0], corners[1]);
  const glm::dvec3 v = edgeOf(positions, corners[0], corners[2]);
  const glm::dvec3 products = glm::abs(glm::dvec3(u.y * v.z, u.z * v.x, u.x * v.y)) +
                              glm::abs(glm::dvec3(u.z * v.y, u.x * v.z, u.y * v.x));
  if (largestMagnitude(products) > 0x1p24 * largest)
  {
    return;
  }
  const double factor = 1.0 / glm::length(plane.normal);
  const glm::dvec3 sides = glm::abs(u) + glm::abs(v);
  totals.sharpness =
      std::max(totals.sharpness, (sides.x + sides.y + sides.z) * factor * this->geometry.reach);
  this->geometry.planeBlocks[triangle / PlaneBlock::triangles].set(
      triangle % PlaneBlock::triangles, plane.normal * factor, plane.offset * factor / this->geometry.reach);
}

void SEDGeometryBuilder::makeClusters()
{
  this->geometry.edgeTable = makeEdgeTable(this->edges, this->geometry.triangles);
  std::vector<Edge>().swap(this->edges);
  this->geometry.clusterTree =
      ClusterTree(this->geometry.planeBlocks, this->geometry.edgeTable, this->geometry.triangles,
                  this->geometry.positions, this->geometry.reach, this->options.parallelFor);
}

void SEDGeometryBuilder::findCommonPlane()
{
  TrianglePlane first{};
  for (std::size_t triangle = 0; first.normal == glm::dvec3(0.0); ++triangle)
  {
    if (triangle == this->geometry.triangles.size())
    {
      return;
    }
    first = this->geometry.getPlane(triangle);
  }
  const glm::dvec4 plane = glm::dvec4(first.normal, first.offset) / glm::length(first.normal);
  const double tolerance = 1e-6 * glm::distance(this->geometry.lowerBound, this->geometry.upperBound);
  const bool common = std::all_of(this->geometry.positions.begin(), this->geometry.positions.end(),
                                  [&](const glm::vec3& position) {
                                    return std::abs(glm::dot(plane, glm::dvec4(position, 1.0))) <= tolerance;
                                  });
  if (common)
  {
    this->geometry.commonPlane = plane;
  }
}

/// Is this the other mesh with other positions? Triangles count as they are oriented, not as they came.
bool SEDGeometryBuilder::isMoved(const SEDGeometry& other) const
{
  if (!this->hasPreviousOrder || this->geometry.positions.size() != other.positions.size())
  {
    return false;
  }
  if (this->hasPreviousEdges)
  {
    // The edges are those of the other mesh; deformed, a component may have been turned inside out.
    bool same = true;
    for (std::size_t word = 0; same && word < other.reversed.getWords().size(); ++word)
    {
      const auto turned = [word](const SEDGeometry& mesh)
      { return mesh.reversed.getWords()[word] ^ mesh.inputReversed.getWords()[word]; };
      same = turned(this->geometry) == turned(other);
    }
    return same;
  }
  // Edges that run alike between the same triangles tell how these are oriented.
  const EdgeList mine = this->geometry.getEdges();
  const EdgeList others = other.getEdges();
  return std::equal(mine.begin(), mine.end(), others.begin(), others.end(),
                    [](const Edge& edge, const Edge& otherEdge)
                    { return edge.vertices == otherEdge.vertices && edge.triangles == otherEdge.triangles; });
}

void SEDGeometryBuilder::identify()
{
  const SEDGeometry* previous = this->options.previous;
  const bool moved = previous != nullptr && this->isMoved(*previous);
  this->geometry.topology = moved ? previous->topology : nextRevision();
  const bool sameOrder = moved && this->geometry.triangles == previous->triangles &&
                         this->geometry.reversed.getWords() == previous->reversed.getWords() &&
                         this->geometry.inputReversed.getWords() == previous->inputReversed.getWords();
  this->geometry.rasterOrder = sameOrder ? previous->rasterOrder : nextRevision();
}

} // namespace shadow
