#include "EdgeScan.h"

#include <array>
#include <cstddef>
#include <cstdlib>

#include "EdgeKernel.h"

namespace shadow
{

namespace
{

/// 1 when the triangle casts as it is oriented, -1 when it casts turned over, 0 when it does not cast.
int getSign(const LightFacing& facing, Casting casting, std::uint32_t triangle)
{
  const int towards = facing.towards.test(triangle) ? 1 : 0;
  return casting == Casting::LightFacing ? towards : towards - (facing.away.test(triangle) ? 1 : 0);
}

bool isUniform(std::uint64_t word)
{
  return word == 0 || word == ~std::uint64_t{0};
}

/// Does every triangle have one of its bits? Then triangles differ in both bits or in none.
bool isDecided(const LightFacing& facing)
{
  std::size_t missing = 64 * facing.towards.getWords().size() - facing.towards.size();
  const std::vector<std::uint64_t>& towards = facing.towards.getWords();
  const std::vector<std::uint64_t>& away = facing.away.getWords();
  if (missing > 0 && (towards.back() ^ away.back()) != ~std::uint64_t{0} >> missing)
  {
    return false;
  }
  const std::size_t whole = towards.size() - (missing > 0 ? 1 : 0);
  std::uint64_t all = ~std::uint64_t{0};
  for (std::size_t word = 0; word < whole; ++word)
  {
    all &= towards[word] ^ away[word];
  }
  return all == ~std::uint64_t{0};
}

std::vector<DifferingEdge> compareAll(const SEDGeometry& geometry, const LightFacing& facing, Casting casting)
{
  const EdgeKernels kernels = getEdgeKernels(getInstructionSets().back());
  const std::size_t words = facing.towards.getWords().size();
  const std::uint64_t* towards = facing.towards.getWords().data();
  const bool both = casting == Casting::EveryTriangle && !isDecided(facing);
  const std::uint64_t* away = both ? facing.away.getWords().data() : nullptr;
  std::vector<DifferingEdge> differing;
  kernels.compareInner(geometry.getEdgeTable(), towards, away, 0, words, differing);
  kernels.compareOuter(geometry.getEdgeTable(), towards, away, 0, words, differing);
  return differing;
}

std::vector<DifferingEdge> compareWords(const SEDGeometry& geometry, const LightFacing& facing,
                                        Casting casting, const std::vector<std::uint32_t>& words)
{
  const EdgeKernels kernels = getEdgeKernels(getInstructionSets().back());
  const std::uint64_t* towards = facing.towards.getWords().data();
  const bool both = casting == Casting::EveryTriangle;
  const std::uint64_t* away = both ? facing.away.getWords().data() : nullptr;
  std::vector<DifferingEdge> differing;
  for (const std::uint32_t word : words)
  {
    // No inner edge differs where all triangles of the word face alike.
    if (!isUniform(towards[word]) || (both && !isUniform(away[word])))
    {
      kernels.compareInner(geometry.getEdgeTable(), towards, away, word, std::size_t{word} + 1, differing);
    }
    kernels.compareOuter(geometry.getEdgeTable(), towards, away, word, std::size_t{word} + 1, differing);
  }
  return differing;
}

/// Adds an edge when the sum over its triangles of how they run through it, each turned to the light, is not
/// zero.
void addEdge(const SEDGeometry& geometry, std::uint32_t first, std::uint32_t side, int sum,
             std::vector<SilhouetteEdge>& silhouette)
{
  if (sum != 0)
  {
    // Looked up, as which way an edge runs is nothing that a processor could foresee.
    const std::array<std::uint32_t, 2> ends = geometry.getSide(first, side);
    const std::size_t from = sum < 0 ? 1 : 0;
    silhouette.push_back({ends[from], ends[1 - from], static_cast<std::uint32_t>(std::abs(sum))});
  }
}

} // namespace

std::vector<SilhouetteEdge> scanEdges(const SEDGeometry& geometry, const LightFacing& facing, Casting casting,
                                      const std::vector<std::uint32_t>* words)
{
  const std::vector<DifferingEdge> differing = words == nullptr
                                                   ? compareAll(geometry, facing, casting)
                                                   : compareWords(geometry, facing, casting, *words);
  const std::vector<std::uint32_t>& borders = geometry.getEdgeTable().borders;
  std::vector<SilhouetteEdge> silhouette;
  silhouette.reserve(differing.size() + borders.size());
  for (const DifferingEdge& edge : differing)
  {
    const int sum = getSign(facing, casting, edge.first) - getSign(facing, casting, edge.second);
    addEdge(geometry, edge.first, edge.side, sum, silhouette);
  }
  for (const std::uint32_t border : borders)
  {
    addEdge(geometry, border / 3, border % 3, getSign(facing, casting, border / 3), silhouette);
  }
  return silhouette;
}

} // namespace shadow
