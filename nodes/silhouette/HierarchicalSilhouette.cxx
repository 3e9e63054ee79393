#include "HierarchicalSilhouette.h"

#include <cstddef>
#include <cstdint>

#include "EdgeScan.h"
#include "FacingBits.h"
#include "FacingDecider.h"
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

void HierarchicalSilhouette::face(const SEDGeometry& geometry, const glm::dvec4& lightMC,
                                  LightFacing& facing) const
{
  const FacingDecider decider(geometry, lightMC);
  if (!decider.isLit())
  {
    computeFacing(geometry, lightMC, facing);
    return;
  }
  facing.towards.resize(geometry.getTriangles().size());
  facing.away.resize(geometry.getTriangles().size());
  if (!facing.mixedWords)
  {
    facing.mixedWords.emplace();
  }
  facing.mixedWords->clear();
  std::vector<ClusterTree::Quarters> mixed;
  geometry.getClusterTree().classify(decider.getScaledLight(), facing.towards, facing.away, mixed);
  facing.mixedWords->reserve(mixed.size());
  constexpr std::size_t ahead = 12;
  std::vector<std::uint32_t> doubtful;
  for (std::size_t index = 0; index < mixed.size(); ++index)
  {
    if (index + ahead < mixed.size())
    {
      prefetchQuarters(geometry.getPlaneBlocks()[mixed[index + ahead].word], mixed[index + ahead].bits);
    }
    decider.compare(mixed[index].word, mixed[index].bits, facing, doubtful);
    facing.mixedWords->push_back(mixed[index].word);
  }
  decider.resolve(doubtful, facing);
}

std::vector<SilhouetteEdge> HierarchicalSilhouette::find(const SEDGeometry& geometry,
                                                         const LightFacing& facing, Casting casting) const
{
  const EdgeScan scan(geometry, facing, casting);
  std::vector<SilhouetteEdge> silhouette;
  if (facing.mixedWords)
  {
    scan.addWords(*facing.mixedWords, silhouette);
  }
  else
  {
    scan.addWords(0, geometry.getPlaneBlocks().size(), silhouette);
  }
  scan.addBorders(silhouette);
  return silhouette;
}

} // namespace shadow
