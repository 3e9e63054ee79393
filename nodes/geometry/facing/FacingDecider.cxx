#include "FacingDecider.h"

#include <array>
#include <cmath>

#include "ExactOrientation.h"
#include "Prefetch.h"

namespace shadow
{

namespace
{

void prefetchQuarters(const PlaneBlock& block, unsigned int quarters)
{
  for (; quarters != 0; quarters &= quarters - 1)
  {
    const std::size_t slot = PlaneBlock::quarter * findLowestBit(quarters);
    prefetch(&block.xy[slot], PlaneBlock::quarter * sizeof(PlaneBlock::Pair));
    prefetch(&block.zOffset[slot], PlaneBlock::quarter * sizeof(PlaneBlock::Pair));
  }
}

} // namespace

FacingDecider::FacingDecider(const SEDGeometry& theGeometry, const glm::dvec4& theLightMC, InstructionSet set)
    : geometry(theGeometry), lightMC(theLightMC), light(scaleLight(theLightMC, theGeometry.getReach())),
      lightAsRounded(this->light.x, this->light.y, this->light.z, this->light.w),
      lightInUnits(toUnits(this->light)), kernel(getPlaneKernel(set))
{
}

void FacingDecider::widenDoubt(double margin)
{
  const glm::dvec4 size = glm::abs(this->lightAsRounded);
  // A plane's value is at most the sum: then all are doubtful.
  const double added = (margin < 1.0 ? margin : 1.0) * (size.x + size.y + size.z + size.w);
  this->light.bound += static_cast<float>(added);
  this->lightInUnits = toUnits(this->light);
}

void FacingDecider::decide(std::size_t firstWord, std::size_t endWord, LightFacing& facing) const
{
  std::uint64_t* towards = facing.towards.data();
  std::uint64_t* away = facing.away.data();
  this->kernel.compareBlocks(this->geometry.getPlaneBlocks().data() + firstWord, endWord - firstWord,
                             this->lightInUnits, towards + firstWord, away + firstWord);
  std::vector<std::uint32_t> doubtful;
  for (std::size_t word = firstWord; word < endWord; ++word)
  {
    this->decideOpen(word, ~(towards[word] | away[word]), facing, doubtful);
  }
  this->resolve(doubtful, facing);
}

void FacingDecider::compare(std::size_t word, unsigned int quarters, LightFacing& facing,
                            std::vector<std::uint32_t>& doubtful) const
{
  std::uint64_t& towards = facing.towards.data()[word];
  std::uint64_t& away = facing.away.data()[word];
  this->kernel.compareQuarters(this->geometry.getPlaneBlocks()[word], quarters, this->lightInUnits, towards,
                               away);
  // What is not in these quarters has one of its bits, or is beyond the end.
  if (const std::uint64_t open = ~(towards | away); open != 0)
  {
    this->decideOpen(word, open, facing, doubtful);
  }
}

void FacingDecider::compareClusters(LightFacing& facing, std::vector<std::uint32_t>& doubtful) const
{
  facing.towards.resize(this->geometry.getTriangles().size());
  facing.away.resize(this->geometry.getTriangles().size());
  if (!facing.mixedWords)
  {
    facing.mixedWords.emplace();
  }
  facing.mixedWords->clear();
  std::vector<ClusterTree::Quarters> mixed;
  this->geometry.getClusterTree().classify(this->light, facing.towards, facing.away, mixed);
  facing.mixedWords->reserve(mixed.size());
  constexpr std::size_t ahead = 12;
  for (std::size_t index = 0; index < mixed.size(); ++index)
  {
    if (index + ahead < mixed.size())
    {
      prefetchQuarters(this->geometry.getPlaneBlocks()[mixed[index + ahead].word], mixed[index + ahead].bits);
    }
    this->compare(mixed[index].word, mixed[index].bits, facing, doubtful);
    facing.mixedWords->push_back(mixed[index].word);
  }
}

/// Decides triangles of a word that have neither bit, by a finer comparison of their planes.
void FacingDecider::decideOpen(std::size_t word, std::uint64_t open, LightFacing& facing,
                               std::vector<std::uint32_t>& doubtful) const
{
  open &= lowestBits(this->geometry.getTriangles().size() - 64 * word);
  for (; open != 0; open &= open - 1)
  {
    const std::size_t bit = findLowestBit(open);
    const double value = glm::dot(this->geometry.getPlaneBlocks()[word].get(bit), this->lightAsRounded);
    if (std::abs(value) > this->light.bound)
    {
      FacingBits& side = value > 0.0 ? facing.towards : facing.away;
      side.data()[word] |= std::uint64_t{1} << bit;
    }
    else
    {
      doubtful.push_back(static_cast<std::uint32_t>(64 * word + bit));
    }
  }
}

void FacingDecider::resolve(const std::vector<std::uint32_t>& doubtful, LightFacing& facing) const
{
  constexpr std::size_t ahead = 8;
  const std::vector<std::array<std::uint32_t, 3>>& triangles = this->geometry.getTriangles();
  const std::vector<glm::vec3>& positions = this->geometry.getPositions();
  for (std::size_t index = 0; index < doubtful.size(); ++index)
  {
    if (index + 2 * ahead < doubtful.size())
    {
      prefetch(&triangles[doubtful[index + 2 * ahead]], 1);
    }
    if (index + ahead < doubtful.size())
    {
      for (const std::uint32_t vertex : triangles[doubtful[index + ahead]])
      {
        prefetch(&positions[vertex], 1);
      }
    }
    const std::uint32_t triangle = doubtful[index];
    const int sign = this->findSign(triangle);
    const std::uint64_t bit = std::uint64_t{1} << (triangle & 63);
    facing.towards.data()[triangle >> 6] |= sign > 0 ? bit : 0;
    facing.away.data()[triangle >> 6] |= sign < 0 ? bit : 0;
  }
}

/// The exact sign: by a sharper filter in double precision, then by exact arithmetic.
int FacingDecider::findSign(std::uint32_t triangle) const
{
  const std::array<std::uint32_t, 3>& corners = this->geometry.getTriangles()[triangle];
  const std::vector<glm::vec3>& positions = this->geometry.getPositions();
  const int rasterSign =
      orientation(positions[corners[0]], positions[corners[1]], positions[corners[2]], this->lightMC);
  return this->geometry.getReversed().test(triangle) ? -rasterSign : rasterSign;
}

} // namespace shadow
