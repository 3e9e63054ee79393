#include "EdgeScan.h"

#include <algorithm>

#include "CastingTriangles.h"
#include "EdgeKernel.h"
#include "Prefetch.h"

namespace shadow
{

namespace
{

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

/// So many words are asked for before their turn: their edges, and where these lie.
constexpr std::size_t ahead = 8;
constexpr std::size_t farAhead = 24;

void prefetchEdges(const EdgeTable& table, std::uint32_t word)
{
  const EdgeTable::Record record = table.getRecord(word);
  prefetch(record.outerSecond, 5 * record.outer + 2 * record.inner);
}

} // namespace

EdgeScan::EdgeScan(const SEDGeometry& theGeometry, const LightFacing& theFacing, Casting theCasting)
    : geometry(theGeometry), facing(theFacing), casting(theCasting),
      towards(theFacing.towards.getWords().data()), away(nullptr)
{
  // Looking at all words takes less time than comparing all edges twice, but more than a hierarchy may.
  if (theCasting == Casting::EveryTriangle && (theFacing.mixedWords || !isDecided(theFacing)))
  {
    this->away = theFacing.away.getWords().data();
  }
}

int EdgeScan::getSign(std::uint32_t triangle) const
{
  return getCastingSign(this->facing, this->casting, triangle);
}

void EdgeScan::addWords(std::size_t firstWord, std::size_t endWord,
                        std::vector<SilhouetteEdge>& silhouette) const
{
  constexpr std::size_t atOnce = 256;
  const EdgeKernel compareAll = getEdgeKernel(getInstructionSets().back());
  const EdgeTable& table = this->geometry.getEdgeTable();
  std::vector<DifferingEdge> differing;
  for (std::size_t first = firstWord; first < endWord; first += atOnce)
  {
    const std::size_t end = std::min(first + atOnce, endWord);
    compareAll(table, this->towards, this->away, first, end, differing);
    this->prefetchSides(differing, 0);
    this->moveDiffering(differing, silhouette);
  }
}

void EdgeScan::addWords(const std::vector<std::uint32_t>& words,
                        std::vector<SilhouetteEdge>& silhouette) const
{
  constexpr std::size_t atOnce = 256;
  const EdgeKernel compareAll = getEdgeKernel(getInstructionSets().back());
  const EdgeTable& table = this->geometry.getEdgeTable();
  // About half of the words hold an edge, and these some five.
  silhouette.reserve(silhouette.size() + 4 * words.size() + table.borders.size());
  std::vector<DifferingEdge> differing;
  for (std::size_t index = 0; index < words.size(); ++index)
  {
    const std::uint32_t word = words[index];
    if (index + farAhead < words.size())
    {
      prefetch(&table.words[words[index + farAhead]], sizeof(EdgeTable::Word));
    }
    if (index + ahead < words.size())
    {
      prefetchEdges(table, words[index + ahead]);
    }
    const std::size_t before = differing.size();
    compareAll(table, this->towards, this->away, word, std::size_t{word} + 1, differing);
    this->prefetchSides(differing, before);
    if (differing.size() >= atOnce)
    {
      this->moveDiffering(differing, silhouette);
    }
  }
  this->moveDiffering(differing, silhouette);
}

/// Has the processor fetch what moveDiffering() will read, from a place in the list on.
void EdgeScan::prefetchSides(const std::vector<DifferingEdge>& differing, std::size_t begin) const
{
  for (std::size_t index = begin; index < differing.size(); ++index)
  {
    const std::uint32_t triangle = differing[index].first;
    prefetch(&this->geometry.getTriangles()[triangle], 1);
    prefetch(&this->geometry.getReversed().getWords()[triangle >> 6], 1);
  }
}

/// Turns what was found into silhouette edges; the list is empty afterwards.
void EdgeScan::moveDiffering(std::vector<DifferingEdge>& differing,
                             std::vector<SilhouetteEdge>& silhouette) const
{
  for (const DifferingEdge& edge : differing)
  {
    addSide(this->geometry, edge.first, edge.side, this->getSign(edge.first) - this->getSign(edge.second),
            silhouette);
  }
  differing.clear();
}

void EdgeScan::addBorders(std::vector<SilhouetteEdge>& silhouette) const
{
  for (const std::uint32_t border : this->geometry.getEdgeTable().borders)
  {
    addSide(this->geometry, border / 3, border % 3, this->getSign(border / 3), silhouette);
  }
}

} // namespace shadow
