#include "ManifoldSplitter.h"

#include <algorithm>
#include <tuple>

namespace shadow
{

ManifoldSplitter::ManifoldSplitter(std::vector<Triangle>& trianglesIn, std::vector<glm::vec3>& positionsIn)
    : triangles(trianglesIn), positions(positionsIn)
{
}

void ManifoldSplitter::run()
{
  this->partner.assign(3 * this->triangles.size(), none);
  this->surfaces.assign(this->triangles.size(), none);
  this->flipped.assign(this->triangles.size(), 0);
  this->sortSides();
  this->orient();
  this->pairCrowds();
  this->renumber();
  this->applyTurns();
}

/// After its triangle was turned, does the side run from the lower to the higher vertex index?
bool ManifoldSplitter::runsUpwards(Side side) const
{
  return (this->vertexAt(side) < this->vertexAfter(side)) != (this->flipped[side / 3] != 0);
}

/// Neighbours are wound alike when they run through their edge in opposite directions.
bool ManifoldSplitter::agree(Side a, Side b) const
{
  return this->runsUpwards(a) != this->runsUpwards(b);
}

void ManifoldSplitter::pair(Side a, Side b)
{
  this->partner[a] = b;
  this->partner[b] = a;
}

/// Distributes the sides over their lower vertices, then sorts the few at each vertex by the higher one.
void ManifoldSplitter::sortSides()
{
  const auto sides = static_cast<Side>(3 * this->triangles.size());
  std::vector<std::uint32_t> starts(this->positions.size() + 1, 0);
  const auto lower = [this](Side side) { return std::min(this->vertexAt(side), this->vertexAfter(side)); };
  const auto higher = [this](Side side) { return std::max(this->vertexAt(side), this->vertexAfter(side)); };
  for (Side side = 0; side < sides; ++side)
  {
    ++starts[lower(side)];
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& start : starts)
  {
    sum += start;
    start = sum;
  }
  this->sortedSides.resize(sides);
  for (Side side = sides; side-- > 0;)
  {
    this->sortedSides[--starts[lower(side)]] = side;
  }
  for (std::size_t vertex = 0; vertex + 1 < starts.size(); ++vertex)
  {
    const auto begin = this->sortedSides.begin() + starts[vertex];
    const auto end = this->sortedSides.begin() + starts[vertex + 1];
    std::sort(begin, end,
              [&higher](Side a, Side b)
              { return std::make_tuple(higher(a), a) < std::make_tuple(higher(b), b); });
    this->pairSimpleEdges(starts[vertex], starts[vertex + 1]);
  }
}

/// Within the sides of one lower vertex: pairs those that are two an edge, notes those that are more.
void ManifoldSplitter::pairSimpleEdges(std::size_t begin, std::size_t end)
{
  const auto sameEdge = [this](Side a, Side b)
  { return this->vertexAt(a) + this->vertexAfter(a) == this->vertexAt(b) + this->vertexAfter(b); };
  for (std::size_t first = begin; first < end;)
  {
    std::size_t last = first + 1;
    while (last < end && sameEdge(this->sortedSides[first], this->sortedSides[last]))
    {
      ++last;
    }
    if (last - first == 2)
    {
      this->pair(this->sortedSides[first], this->sortedSides[first + 1]);
    }
    else if (last - first > 2)
    {
      this->crowds.push_back({first, last});
    }
    first = last;
  }
}

void ManifoldSplitter::orient()
{
  std::vector<std::uint32_t> members;
  std::uint32_t surface = 0;
  for (std::uint32_t seed = 0; seed < this->triangles.size(); ++seed)
  {
    if (this->surfaces[seed] == none)
    {
      const std::size_t turned = this->orientSurface(seed, surface++, members);
      // Leave the majority as it was given, not whichever triangle came first.
      if (2 * turned > members.size())
      {
        for (const std::uint32_t member : members)
        {
          this->flipped[member] ^= 1;
        }
      }
    }
  }
}

/// Turns all triangles that simple edges connect with the seed to agree with it. Where they cannot agree (a
/// Moebius strip), the edge is cut.
///
/// @return  how many were turned; @p members holds all of them
std::size_t ManifoldSplitter::orientSurface(std::uint32_t seed, std::uint32_t surface,
                                            std::vector<std::uint32_t>& members)
{
  std::size_t turned = 0;
  members.assign(1, seed);
  this->surfaces[seed] = surface;
  for (std::size_t next = 0; next < members.size(); ++next)
  {
    for (Side side = 3 * members[next]; side < 3 * members[next] + 3; ++side)
    {
      const Side across = this->partner[side];
      if (across == none)
      {
        continue;
      }
      const std::uint32_t neighbour = across / 3;
      if (this->surfaces[neighbour] == none)
      {
        this->surfaces[neighbour] = surface;
        this->flipped[neighbour] = this->agree(side, across) ? 0 : 1;
        turned += this->flipped[neighbour];
        members.push_back(neighbour);
      }
      else if (!this->agree(side, across))
      {
        this->partner[side] = none;
        this->partner[across] = none;
      }
    }
  }
  return turned;
}

/// Gives every fan of triangles around a vertex a vertex of its own; the first one keeps the old.
void ManifoldSplitter::renumber()
{
  std::vector<Triangle> renumbered(this->triangles.size(), {none, none, none});
  std::vector<std::uint8_t> taken(this->positions.size(), 0);
  for (std::uint32_t corner = 0; corner < 3 * this->triangles.size(); ++corner)
  {
    if (renumbered[corner / 3][corner % 3] != none)
    {
      continue;
    }
    std::uint32_t label = this->vertexAt(corner);
    if (taken[label])
    {
      this->positions.push_back(glm::vec3(this->positions[label]));
      label = static_cast<std::uint32_t>(this->positions.size() - 1);
      ++this->splitVertices;
    }
    else
    {
      taken[label] = 1;
    }
    this->labelFan(corner, label, renumbered);
  }
  this->triangles.swap(renumbered);
}

/// Labels all corners that are reached from the given one by crossing paired sides around their vertex.
void ManifoldSplitter::labelFan(std::uint32_t corner, std::uint32_t label,
                                std::vector<Triangle>& renumbered) const
{
  const std::uint32_t vertex = this->vertexAt(corner);
  renumbered[corner / 3][corner % 3] = label;
  // A corner lies between the side that starts there and the one that ends there: walk off through each.
  const std::uint32_t triangleStart = corner / 3 * 3;
  for (Side exit : {corner, triangleStart + (corner - triangleStart + 2) % 3})
  {
    for (Side across = this->partner[exit]; across != none; across = this->partner[exit])
    {
      const std::uint32_t start = across / 3 * 3;
      const bool startsHere = this->vertexAt(across) == vertex;
      const std::uint32_t here = startsHere ? across : start + (across - start + 1) % 3;
      if (renumbered[here / 3][here % 3] != none)
      {
        break;
      }
      renumbered[here / 3][here % 3] = label;
      exit = startsHere ? start + (across - start + 2) % 3 : here;
    }
  }
}

void ManifoldSplitter::applyTurns()
{
  for (std::size_t triangle = 0; triangle < this->triangles.size(); ++triangle)
  {
    if (this->flipped[triangle])
    {
      std::swap(this->triangles[triangle][1], this->triangles[triangle][2]);
    }
  }
}

} // namespace shadow
