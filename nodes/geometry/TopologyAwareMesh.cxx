#include "TopologyAwareMesh.h"

#include <algorithm>
#include <cmath>

namespace shadow
{

namespace
{

/// The longest edge: of a triangle without area, the one that covers both others.
std::size_t findLongestEdge(const SEDGeometry& geometry, std::size_t face)
{
  const std::array<std::uint32_t, 3>& corners = geometry.getTriangles()[face];
  std::array<double, 3> lengths{};
  for (std::size_t edge = 0; edge < 3; ++edge)
  {
    const glm::dvec3 from(geometry.getPositions()[corners[edge]]);
    const glm::dvec3 to(geometry.getPositions()[corners[(edge + 1) % 3]]);
    lengths[edge] = glm::distance(from, to);
  }
  return static_cast<std::size_t>(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
}

/// Puts edges of the same face into one entry, rising by face.
void gather(std::vector<FaceEdges>& lines)
{
  std::sort(lines.begin(), lines.end(),
            [](const FaceEdges& a, const FaceEdges& b) { return a.face < b.face; });
  std::size_t kept = 0;
  for (const FaceEdges& line : lines)
  {
    if (kept > 0 && lines[kept - 1].face == line.face)
    {
      lines[kept - 1].edges |= line.edges;
    }
    else
    {
      lines[kept++] = line;
    }
  }
  lines.resize(kept);
}

void addSilhouette(const EdgeTable& table, const FacingBits& towards, std::size_t word,
                   std::vector<FaceEdges>& lines)
{
  const EdgeTable::Record record = table.getRecord(word);
  const auto base = static_cast<std::uint32_t>(64 * word);
  const std::uint64_t bits = towards.getWords()[word];
  const auto add = [&](EdgeTable::Code code) {
    lines.push_back({base + EdgeTable::triangleOf(code), 1u << EdgeTable::sideOf(code)});
  };
  for (std::size_t i = 0; i < record.inner; ++i)
  {
    const EdgeTable::Code code = record.innerFirst[i];
    if (((bits >> EdgeTable::triangleOf(code) ^ bits >> EdgeTable::triangleOf(record.innerSecond[i])) & 1u) !=
        0)
    {
      add(code);
    }
  }
  for (std::size_t i = 0; i < record.outer; ++i)
  {
    const EdgeTable::Code code = record.outerFirst[i];
    if ((bits >> EdgeTable::triangleOf(code) & 1u) != (towards.test(record.outerSecond[i]) ? 1u : 0u))
    {
      add(code);
    }
  }
}

void copyBit(FacingBits& bits, std::uint32_t from, std::uint32_t to)
{
  const std::uint64_t mask = std::uint64_t{1} << (to & 63u);
  std::uint64_t& word = bits.data()[to >> 6];
  word = bits.test(from) ? word | mask : word & ~mask;
}

} // namespace

TopologyAwareMesh::TopologyAwareMesh(const SEDGeometry& geometry)
{
  const std::size_t faces = geometry.getTriangles().size();
  this->neighbours.assign(faces, {noTriangle, noTriangle, noTriangle});
  this->normals.resize(faces);
  for (std::size_t face = 0; face < faces; ++face)
  {
    const glm::dvec3 normal = geometry.getPlane(face).normal;
    const double length = glm::length(normal);
    this->normals[face] = length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0f);
  }
  this->linkNeighbours(geometry);
  this->pairBorders(geometry);
  this->findStandIns(geometry);
}

void TopologyAwareMesh::linkNeighbours(const SEDGeometry& geometry)
{
  forEachEdge(geometry.getEdgeTable(),
              [&](std::uint32_t first, std::uint32_t side, std::uint32_t second)
              {
                if (second == noTriangle)
                {
                  return;
                }
                this->neighbours[first][side] = second;
                const std::array<std::uint32_t, 2> ends = geometry.getSide(first, side);
                for (const std::uint32_t other : {0u, 1u, 2u})
                {
                  const std::array<std::uint32_t, 2> otherEnds = geometry.getSide(second, other);
                  if (std::is_permutation(ends.begin(), ends.end(), otherEnds.begin()))
                  {
                    this->neighbours[second][other] = first;
                  }
                }
              });
}

// Borders at the same place, two of them, along which their faces run the same way.
void TopologyAwareMesh::pairBorders(const SEDGeometry& geometry)
{
  struct Place
  {
    std::array<float, 6> ends; ///< positions, the lesser one first
    bool forwards;             ///< the oriented face runs from there
    std::uint32_t side;
  };
  std::vector<Place> places;
  for (const std::uint32_t side : geometry.getEdgeTable().borders)
  {
    const std::array<std::uint32_t, 2> vertices = geometry.getSide(side / 3, side % 3);
    const glm::vec3& from = geometry.getPositions()[vertices[0]];
    const glm::vec3& to = geometry.getPositions()[vertices[1]];
    const std::array<float, 6> there = {from.x, from.y, from.z, to.x, to.y, to.z};
    const std::array<float, 6> back = {to.x, to.y, to.z, from.x, from.y, from.z};
    places.push_back({std::min(there, back), there < back, side});
  }
  std::sort(places.begin(), places.end(),
            [](const Place& a, const Place& b)
            { return a.ends != b.ends ? a.ends < b.ends : a.side < b.side; });
  for (std::size_t first = 0; first < places.size();)
  {
    std::size_t end = first + 1;
    while (end < places.size() && places[end].ends == places[first].ends)
    {
      ++end;
    }
    if (end - first == 2 && places[first].forwards == places[first + 1].forwards)
    {
      this->turnedPairs.push_back({places[first].side, places[first + 1].side});
      this->turnedPairs.push_back({places[first + 1].side, places[first].side});
    }
    else
    {
      for (; first < end; ++first)
      {
        this->borders.push_back(places[first].side);
      }
    }
    first = end;
  }
  std::sort(this->borders.begin(), this->borders.end());
  std::sort(this->turnedPairs.begin(), this->turnedPairs.end(),
            [](const TurnedPair& a, const TurnedPair& b) { return a.side < b.side; });
}

glm::vec3 TopologyAwareMesh::getNeighbourNormal(std::size_t face, std::size_t edge) const
{
  const std::uint32_t neighbour = this->neighbours[face][edge];
  if (neighbour != noTriangle)
  {
    return this->normals[neighbour];
  }
  const auto side = static_cast<std::uint32_t>(3 * face + edge);
  const auto pair = std::lower_bound(this->turnedPairs.begin(), this->turnedPairs.end(), side,
                                     [](const TurnedPair& a, std::uint32_t b) { return a.side < b; });
  const bool turned = pair != this->turnedPairs.end() && pair->side == side;
  return -this->normals[turned ? pair->other / 3 : face];
}

// From face to face across their longest edges, which only get longer, until one has an area.
void TopologyAwareMesh::findStandIns(const SEDGeometry& geometry)
{
  if (geometry.getReport().zeroAreaTriangles == 0)
  {
    return;
  }
  const auto hasNormal = [this](std::uint32_t face) { return this->normals[face] != glm::vec3(0.0f); };
  std::vector<bool> visited(this->countFaces(), false);
  std::vector<std::uint32_t> chain;
  for (std::uint32_t start = 0; start < this->countFaces(); ++start)
  {
    chain.clear();
    std::uint32_t face = start;
    // A chain that comes to a face it has been to, or to one whose own chain found nothing, finds nothing.
    while (face != noTriangle && !hasNormal(face) && !visited[face])
    {
      visited[face] = true;
      chain.push_back(face);
      face = this->neighbours[face][findLongestEdge(geometry, face)];
    }
    if (face == noTriangle || !hasNormal(face))
    {
      continue;
    }
    for (auto member = chain.rbegin(); member != chain.rend(); ++member)
    {
      this->normals[*member] = this->normals[face];
      this->standIns.push_back({*member, face});
    }
  }
}

void TopologyAwareMesh::completeFacing(LightFacing& facing) const
{
  for (const StandIn& standIn : this->standIns)
  {
    copyBit(facing.towards, standIn.source, standIn.face);
    copyBit(facing.away, standIn.source, standIn.face);
  }
}

void TopologyAwareMesh::findLines(const SEDGeometry& geometry, const LightFacing& facing,
                                  const LineKinds& kinds, std::vector<FaceEdges>& lines) const
{
  lines.clear();
  const EdgeTable& table = geometry.getEdgeTable();
  if (kinds.silhouette && facing.mixedWords)
  {
    for (const std::uint32_t word : *facing.mixedWords)
    {
      addSilhouette(table, facing.towards, word, lines);
    }
  }
  else if (kinds.silhouette)
  {
    for (std::size_t word = 0; word < table.words.size(); ++word)
    {
      addSilhouette(table, facing.towards, word, lines);
    }
  }
  for (const TurnedPair& pair : this->turnedPairs)
  {
    if (kinds.silhouette && pair.side < pair.other &&
        facing.towards.test(pair.side / 3) == facing.towards.test(pair.other / 3))
    {
      lines.push_back({pair.side / 3, 1u << pair.side % 3});
    }
  }
  if (kinds.border)
  {
    for (const std::uint32_t border : this->borders)
    {
      lines.push_back({border / 3, 1u << border % 3});
    }
  }
  if (kinds.creases != nullptr)
  {
    lines.insert(lines.end(), kinds.creases->begin(), kinds.creases->end());
  }
  gather(lines);
}

std::vector<FaceEdges> TopologyAwareMesh::findCreases(const SEDGeometry& geometry, double degrees) const
{
  const double largestCosine = std::cos(std::clamp(degrees, 0.0, 180.0) * 3.14159265358979323846 / 180.0);
  std::vector<FaceEdges> creases;
  const auto add = [&](std::uint32_t face, std::uint32_t edge)
  {
    const glm::dvec3 one(this->normals[face]);
    const glm::dvec3 other(this->getNeighbourNormal(face, edge));
    if (one != glm::dvec3(0.0) && other != glm::dvec3(0.0) && glm::dot(one, other) < largestCosine)
    {
      creases.push_back({face, 8u << edge});
    }
  };
  forEachEdge(geometry.getEdgeTable(), [&](std::uint32_t first, std::uint32_t side, std::uint32_t second)
              { second != noTriangle ? add(first, side) : void(); });
  for (const TurnedPair& pair : this->turnedPairs)
  {
    pair.side < pair.other ? add(pair.side / 3, pair.side % 3) : void();
  }
  gather(creases);
  return creases;
}

std::size_t TopologyAwareMesh::getMemorySize() const
{
  return this->neighbours.capacity() * sizeof(this->neighbours[0]) +
         this->normals.capacity() * sizeof(this->normals[0]) +
         this->borders.capacity() * sizeof(this->borders[0]) +
         this->turnedPairs.capacity() * sizeof(this->turnedPairs[0]) +
         this->standIns.capacity() * sizeof(this->standIns[0]);
}

} // namespace shadow
