#include "EdgeScan.h"

#include <algorithm>
#include <memory>

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

/// Collects edges whose triangles differ, so that where these lie is fetched before it is read.
class EdgeScan::Batch
{
public:
  Batch(const EdgeScan& theScan, std::vector<SilhouetteEdge>& theSilhouette)
      : scan(theScan), silhouette(theSilhouette), found(new DifferingEdge[room])
  {
  }

  /// @param endWord  at most wordsAtOnce after @p firstWord
  void add(std::size_t firstWord, std::size_t endWord)
  {
    DifferingEdge* const begin = this->found.get() + this->count;
    DifferingEdge* const end = this->compareAll(this->scan.geometry.getEdgeTable(), this->scan.towards,
                                                this->scan.away, firstWord, endWord, begin);
    this->scan.prefetchSides(begin, end);
    this->count += static_cast<std::size_t>(end - begin);
    if (this->count >= enough)
    {
      this->finish();
    }
  }

  /// Turns what was found into silhouette edges.
  void finish()
  {
    this->scan.addSides(this->found.get(), this->found.get() + this->count, this->silhouette);
    this->count = 0;
  }

  static constexpr std::size_t wordsAtOnce = 16;

private:
  static constexpr std::size_t enough = 256;
  static constexpr std::size_t room = enough + wordsAtOnce * EdgeTable::mostOfWord;

  const EdgeScan& scan;
  std::vector<SilhouetteEdge>& silhouette;
  const EdgeKernel compareAll = getEdgeKernel(getInstructionSets().back());
  std::unique_ptr<DifferingEdge[]> found; ///< not set to anything: most of it is never needed
  std::size_t count = 0;
};

void EdgeScan::addWords(std::size_t firstWord, std::size_t endWord,
                        std::vector<SilhouetteEdge>& silhouette) const
{
  Batch batch(*this, silhouette);
  for (std::size_t first = firstWord; first < endWord; first += Batch::wordsAtOnce)
  {
    batch.add(first, std::min(first + Batch::wordsAtOnce, endWord));
  }
  batch.finish();
}

void EdgeScan::addWords(const std::vector<std::uint32_t>& words,
                        std::vector<SilhouetteEdge>& silhouette) const
{
  const EdgeTable& table = this->geometry.getEdgeTable();
  // Nine of ten words hold an edge of a smooth silhouette, and these some five.
  silhouette.reserve(silhouette.size() + 6 * words.size() + table.borders.size());
  Batch batch(*this, silhouette);
  for (std::size_t index = 0; index < words.size(); ++index)
  {
    if (index + farAhead < words.size())
    {
      const std::uint32_t word = words[index + farAhead];
      prefetch(&table.words[word], sizeof(EdgeTable::Word));
      prefetch(&this->geometry.getReversed().getWords()[word], sizeof(std::uint64_t));
    }
    if (index + ahead < words.size())
    {
      prefetchEdges(table, words[index + ahead]);
    }
    batch.add(words[index], std::size_t{words[index]} + 1);
  }
  batch.finish();
}

/// Has the processor fetch what addSides() will read of triangles.
void EdgeScan::prefetchSides(const DifferingEdge* begin, const DifferingEdge* end) const
{
  for (const DifferingEdge* edge = begin; edge != end; ++edge)
  {
    prefetch(&this->geometry.getTriangles()[edge->first], 1);
  }
}

void EdgeScan::addSides(const DifferingEdge* begin, const DifferingEdge* end,
                        std::vector<SilhouetteEdge>& silhouette) const
{
  // Where every triangle faces the light or looks away from it, those of an edge that differ do the opposite.
  const int step = this->casting == Casting::LightFacing ? 1 : 2;
  for (const DifferingEdge* edge = begin; edge != end; ++edge)
  {
    const int forwards = this->facing.towards.test(edge->first) ? step : -step;
    const int runs =
        this->away == nullptr ? forwards : this->getSign(edge->first) - this->getSign(edge->second);
    addSide(this->geometry, edge->first, edge->side, runs, silhouette);
  }
}

void EdgeScan::addBorders(std::vector<SilhouetteEdge>& silhouette) const
{
  for (const std::uint32_t border : this->geometry.getEdgeTable().borders)
  {
    addSide(this->geometry, border / 3, border % 3, this->getSign(border / 3), silhouette);
  }
}

} // namespace shadow
