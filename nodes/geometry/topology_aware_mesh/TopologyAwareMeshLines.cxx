// Which edges of a TopologyAwareMesh are lines.
#include "TopologyAwareMesh.h"

#include <algorithm>
#include <cmath>

namespace shadow
{

namespace
{

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
  this->removeWithoutSide(lines);
  for (const TurnedPair& pair : this->turnedPairs)
  {
    if (kinds.silhouette && this->hasSide(pair.side / 3) && this->hasSide(pair.other / 3) &&
        pair.side < pair.other && facing.towards.test(pair.side / 3) == facing.towards.test(pair.other / 3))
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

// @param lines  one edge each
void TopologyAwareMesh::removeWithoutSide(std::vector<FaceEdges>& lines) const
{
  if (this->allHaveSides)
  {
    return;
  }
  const auto isWithout = [this](const FaceEdges& line)
  {
    const std::size_t edge = line.edges >> 1; // 0, 1, 2 for the bits 1, 2, 4
    return !this->hasSide(line.face) || !this->hasSide(this->neighbours[line.face][edge]);
  };
  lines.erase(std::remove_if(lines.begin(), lines.end(), isWithout), lines.end());
}

std::vector<FaceEdges> TopologyAwareMesh::findCreases(const SEDGeometry& geometry, double degrees) const
{
  const double largestCosine = std::cos(std::clamp(degrees, 0.0, 180.0) * 3.14159265358979323846 / 180.0);
  std::vector<FaceEdges> creases;
  const auto isSharp = [&](std::uint32_t face, std::uint32_t edge)
  {
    const glm::dvec3 one(this->normals[face]);
    const glm::dvec3 other(this->getNeighbourNormal(face, edge));
    return one != glm::dvec3(0.0) && other != glm::dvec3(0.0) && glm::dot(one, other) < largestCosine;
  };
  forEachEdge(geometry.getEdgeTable(),
              [&](std::uint32_t first, std::uint32_t side, std::uint32_t second)
              {
                if (second != noTriangle && isSharp(first, side) &&
                    !lieAlike(geometry, this->getSource(first), this->getSource(second)))
                {
                  creases.push_back({first, 8u << side});
                }
              });
  for (const TurnedPair& pair : this->turnedPairs)
  {
    if (pair.side < pair.other && isSharp(pair.side / 3, pair.side % 3))
    {
      creases.push_back({pair.side / 3, 8u << pair.side % 3});
    }
  }
  gather(creases);
  return creases;
}

} // namespace shadow
