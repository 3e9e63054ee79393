#include "VETCollector.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

#include "Revision.h"

namespace shadow
{

namespace
{

using Corners = std::array<std::uint32_t, 3>;

bool isMirrored(const glm::dmat4& modelToWorld)
{
  return glm::determinant(glm::dmat3(modelToWorld)) < 0.0;
}

void setBit(FacingBits& bits, std::size_t place, bool value)
{
  const std::uint64_t bit = std::uint64_t{1} << (place & 63);
  std::uint64_t& word = bits.data()[place >> 6];
  word = value ? word | bit : word & ~bit;
}

Corners cornersOf(const VETRange& range, std::size_t triangle)
{
  Corners corners = range.geometry->getTriangles()[triangle];
  for (std::uint32_t& corner : corners)
  {
    corner += range.firstVertex;
  }
  return corners;
}

/// An edge of the geometry as one of the collection.
Edge placeEdge(const VETRange& range, Edge edge)
{
  for (std::uint32_t& vertex : edge.vertices)
  {
    vertex += range.firstVertex;
  }
  for (std::uint32_t& triangle : edge.triangles)
  {
    triangle += triangle == noTriangle ? 0 : range.firstTriangle;
  }
  if (range.mirrored)
  {
    // In the world both triangles run the other way.
    std::swap(edge.vertices[0], edge.vertices[1]);
  }
  return edge;
}

void gatherCorners(VETCollection& collection, const VETRange& range)
{
  for (std::size_t triangle = 0; triangle < range.countTriangles(); ++triangle)
  {
    const std::size_t place = range.firstTriangle + triangle;
    collection.triangles[place] = cornersOf(range, triangle);
    setBit(collection.reversed, place, range.geometry->getReversed().test(triangle) != range.mirrored);
  }
}

void gatherPositions(VETCollection& collection, const VETRange& range)
{
  const SceneFrame& frame = collection.frame;
  glm::dmat4 sceneFromRelative = worldFromRelative(*range.geometry, range.modelToWorld);
  sceneFromRelative[3] -= glm::dvec4(frame.originWC, 0.0);
  const glm::dmat3 linear = glm::dmat3(sceneFromRelative) / frame.unit;
  const glm::dvec3 shift = glm::dvec3(sceneFromRelative[3]) / frame.unit;
  const std::vector<glm::vec3>& positions = range.geometry->getPositions();
  for (std::size_t vertex = 0; vertex < positions.size(); ++vertex)
  {
    const SplitVector scene = split(linear * glm::dvec3(positions[vertex]) + shift);
    collection.high[range.firstVertex + vertex] = scene.high;
    collection.low[range.firstVertex + vertex] = scene.low;
  }
}

} // namespace

void VETCollector::apply(SEDGeode& geode)
{
  const glm::dmat4& worldFromModel = this->getModelToWorld();
  // The same child twice under one parent is the same path, and the same surface twice.
  if (!isInvertible(worldFromModel) || !this->placeOfPath.emplace(this->getPath(), this->found.size()).second)
  {
    return;
  }
  VETRange range;
  range.path = this->getPath();
  range.geometry = geode.getSharedGeometry();
  range.modelToWorld = worldFromModel;
  range.casting = this->isCasting();
  range.mirrored = isMirrored(worldFromModel);
  range.firstVertex = static_cast<std::uint32_t>(this->foundVertices);
  range.firstTriangle = static_cast<std::uint32_t>(this->foundTriangles);
  range.firstEdge = static_cast<std::uint32_t>(this->foundEdges);
  this->foundVertices += range.countVertices();
  this->foundTriangles += range.countTriangles();
  this->foundEdges += range.countEdges();
  this->found.push_back(std::move(range));
}

VETCollector::Change VETCollector::collect(Node& root)
{
  this->found.clear();
  this->placeOfPath.clear();
  this->foundVertices = this->foundTriangles = this->foundEdges = 0;
  root.accept(*this);
  constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();
  if (std::max({this->foundVertices, this->foundTriangles, this->foundEdges}) > most)
  {
    this->collection = {};
    throw std::length_error("more than 2147483647 vertices, triangles or edges in all");
  }
  return this->hasSameTopology() ? this->gatherMoved() : this->gatherEverything();
}

bool VETCollector::hasSameTopology() const
{
  const std::vector<VETRange>& ranges = this->collection.ranges;
  return this->collection.topologyRevision != 0 &&
         std::equal(ranges.begin(), ranges.end(), this->found.begin(), this->found.end(),
                    [](const VETRange& known, const VETRange& now) {
                      return known.mirrored == now.mirrored &&
                             isSameMeshMoved(*known.geometry, *now.geometry);
                    });
}

SceneFrame VETCollector::chooseFrame(bool mayKeep) const
{
  glm::dvec3 lowerWC(std::numeric_limits<double>::max());
  glm::dvec3 upperWC(std::numeric_limits<double>::lowest());
  for (const VETRange& range : this->found)
  {
    for (const glm::dvec3& corner : worldCorners(*range.geometry, range.modelToWorld))
    {
      lowerWC = glm::min(lowerWC, corner);
      upperWC = glm::max(upperWC, corner);
    }
  }
  if (this->found.empty() || (mayKeep && this->collection.frame.suits(lowerWC, upperWC)))
  {
    return this->collection.frame;
  }
  return SceneFrame::around(lowerWC, upperWC);
}

VETCollector::Change VETCollector::gatherEverything()
{
  this->collection.frame = this->chooseFrame(false);
  this->collection.high.resize(this->foundVertices);
  this->collection.low.resize(this->foundVertices);
  this->collection.triangles.resize(this->foundTriangles);
  this->collection.reversed.assign(this->foundTriangles);
  this->collection.edges.clear();
  this->collection.edges.reserve(this->foundEdges);
  this->collection.ranges = this->found;
  this->collection.rangeOfPath = this->placeOfPath;
  this->collection.topologyRevision = nextRevision();
  for (VETRange& range : this->collection.ranges)
  {
    for (const Edge& edge : range.geometry->getEdges())
    {
      this->collection.edges.push_back(placeEdge(range, edge));
    }
    gatherCorners(this->collection, range);
    gatherPositions(this->collection, range);
    range.positionRevision = this->collection.topologyRevision;
  }
  return Change::Everything;
}

VETCollector::Change VETCollector::gatherMoved()
{
  const SceneFrame frame = this->chooseFrame(true);
  const bool newFrame = !(frame == this->collection.frame);
  this->collection.frame = frame;
  // Other nodes may have taken the places of those that were there.
  this->collection.rangeOfPath = this->placeOfPath;
  const std::uint64_t revision = nextRevision();
  Change change = Change::Nothing;
  for (std::size_t place = 0; place < this->found.size(); ++place)
  {
    const VETRange& now = this->found[place];
    VETRange& range = this->collection.ranges[place];
    const bool rebuilt = range.geometry != now.geometry;
    const bool moved = rebuilt || newFrame || range.modelToWorld != now.modelToWorld;
    range.path = now.path;
    range.casting = now.casting;
    range.geometry = now.geometry;
    range.modelToWorld = now.modelToWorld;
    if (moved)
    {
      if (rebuilt)
      {
        gatherCorners(this->collection, range);
      }
      gatherPositions(this->collection, range);
      range.positionRevision = revision;
      change = Change::Positions;
    }
  }
  return change;
}

} // namespace shadow
