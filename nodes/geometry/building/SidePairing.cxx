#include "SidePairing.h"

#include <algorithm>
#include <atomic>
#include <numeric>

namespace shadow
{

namespace
{

/// Side 3 t + k of triangle t runs from its corner k to the next.
using Side = std::uint32_t;

constexpr Side none = noTriangle;
constexpr std::size_t grain = 1 << 14; ///< triangles or vertices that are worth a thread

Side previousSide(Side side)
{
  return side % 3 == 0 ? side + 2 : side - 1;
}

class SidePairing
{
public:
  SidePairing(const std::vector<std::array<std::uint32_t, 3>>& trianglesIn, std::size_t vertices,
              const ParallelFor& parallelForIn)
      : triangles(trianglesIn), parallelFor(parallelForIn), starts(vertices + 1, 0)
  {
  }

  bool run()
  {
    this->distribute();
    if (!this->sortFans())
    {
      return false;
    }
    this->findPartners();
    return this->areFansWhole();
  }

  std::vector<Edge> takeEdges()
  {
    std::vector<Leaving>().swap(this->leaving);
    return this->listEdges();
  }

private:
  /// A side among those that leave its first vertex.
  struct Leaving
  {
    std::uint32_t end; ///< vertex
    Side side;
  };

  std::uint32_t vertexAt(Side side) const { return this->triangles[side / 3][side % 3]; }
  std::uint32_t vertexAfter(Side side) const
  {
    return this->triangles[side / 3][side % 3 == 2 ? 0 : side % 3 + 1];
  }

  void distribute()
  {
    for (const std::array<std::uint32_t, 3>& corners : this->triangles)
    {
      for (const std::uint32_t corner : corners)
      {
        ++this->starts[corner];
      }
    }
    std::partial_sum(this->starts.begin(), this->starts.end(), this->starts.begin());
    this->leaving.resize(3 * this->triangles.size());
    for (auto side = static_cast<Side>(this->leaving.size()); side-- > 0;)
    {
      this->leaving[--this->starts[this->vertexAt(side)]] = {this->vertexAfter(side), side};
    }
  }

  /// Sorts what leaves each vertex by where it ends. @return  false when two run alike
  bool sortFans()
  {
    return this->holdsForVertices(
        [this](std::size_t vertex)
        {
          Leaving* first = this->leaving.data() + this->starts[vertex];
          Leaving* last = this->leaving.data() + this->starts[vertex + 1];
          std::sort(first, last, [](const Leaving& a, const Leaving& b) { return a.end < b.end; });
          return std::adjacent_find(first, last, [](const Leaving& a, const Leaving& b)
                                    { return a.end == b.end; }) == last;
        });
  }

  /// Of each side the one that runs the other way, or none.
  void findPartners()
  {
    this->partners.resize(3 * this->triangles.size());
    forRanges(this->parallelFor, this->triangles.size(), grain,
              [this](std::size_t begin, std::size_t end)
              {
                for (std::size_t side = 3 * begin; side < 3 * end; ++side)
                {
                  this->partners[side] = this->findOpposite(static_cast<Side>(side));
                }
              });
  }

  Side findOpposite(Side side) const
  {
    const std::uint32_t wanted = this->vertexAt(side);
    const std::uint32_t from = this->vertexAfter(side);
    const auto first = this->leaving.begin() + this->starts[from];
    const auto last = this->leaving.begin() + this->starts[from + 1];
    const auto found = std::lower_bound(first, last, wanted, [](const Leaving& each, std::uint32_t end)
                                        { return each.end < end; });
    return found != last && found->end == wanted ? found->side : none;
  }

  /// Does each vertex have open fans alone, or one that is closed and nothing else?
  bool areFansWhole() const
  {
    return this->holdsForVertices(
        [this](std::size_t vertex)
        {
          const std::size_t begin = this->starts[vertex];
          const std::size_t end = this->starts[vertex + 1];
          std::size_t reached = 0;
          for (std::size_t place = begin; place < end; ++place)
          {
            const Side side = this->leaving[place].side;
            reached += this->partners[side] == none ? this->countFan(side) : 0;
          }
          return begin == end || (reached != 0 ? reached : this->countFan(this->leaving[begin].side)) == end - begin;
        });
  }

  /// Triangles around a vertex from a side that leaves it, to the border or all the way round.
  std::size_t countFan(Side first) const
  {
    std::size_t count = 0;
    Side side = first;
    do
    {
      ++count;
      side = this->partners[previousSide(side)];
    } while (side != none && side != first);
    return count;
  }

  template <typename Law>
  bool holdsForVertices(const Law& law) const
  {
    std::atomic<bool> holds{true};
    forRanges(this->parallelFor, this->starts.size() - 1, grain,
              [&](std::size_t begin, std::size_t end)
              {
                for (std::size_t vertex = begin; vertex < end && holds.load(std::memory_order_relaxed); ++vertex)
                {
                  if (!law(vertex))
                  {
                    holds = false;
                  }
                }
              });
    return holds;
  }

  bool isFirstOfEdge(Side side) const { return this->partners[side] > side; }

  std::vector<Edge> listEdges() const
  {
    const std::size_t parts = (this->triangles.size() + grain - 1) / grain;
    std::vector<std::size_t> begins(parts + 1, 0);
    const auto forSides = [this](std::size_t part, const auto& visit)
    {
      const std::size_t end = 3 * std::min((part + 1) * grain, this->triangles.size());
      for (std::size_t side = 3 * part * grain; side < end; ++side)
      {
        if (this->isFirstOfEdge(static_cast<Side>(side)))
        {
          visit(static_cast<Side>(side));
        }
      }
    };
    const auto forParts = [&](const auto& work)
    {
      forRanges(this->parallelFor, parts, 1,
                [&](std::size_t begin, std::size_t end)
                {
                  for (std::size_t part = begin; part < end; ++part)
                  {
                    work(part);
                  }
                });
    };
    forParts([&](std::size_t part) { forSides(part, [&](Side) { ++begins[part + 1]; }); });
    std::partial_sum(begins.begin(), begins.end(), begins.begin());
    std::vector<Edge> edges(begins.back());
    forParts(
        [&](std::size_t part)
        {
          Edge* next = edges.data() + begins[part];
          forSides(part,
                   [&](Side side)
                   {
                     const Side across = this->partners[side];
                     *next++ = {{this->vertexAt(side), this->vertexAfter(side)},
                                {side / 3, across == none ? noTriangle : across / 3}};
                   });
        });
    return edges;
  }

  const std::vector<std::array<std::uint32_t, 3>>& triangles;
  const ParallelFor& parallelFor;
  std::vector<std::uint32_t> starts; ///< of each vertex in leaving
  std::vector<Leaving> leaving;      ///< by vertex
  std::vector<Side> partners;
};

} // namespace

bool pairSides(const std::vector<std::array<std::uint32_t, 3>>& triangles, std::size_t vertices,
               const ParallelFor& parallelFor, std::vector<Edge>& edges)
{
  SidePairing pairing(triangles, vertices, parallelFor);
  if (!pairing.run())
  {
    return false;
  }
  edges = pairing.takeEdges();
  return true;
}

} // namespace shadow
