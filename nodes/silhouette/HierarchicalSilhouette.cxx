#include "HierarchicalSilhouette.h"

#include <cstddef>
#include <cstdint>

#include "EdgeScan.h"
#include "FacingDecider.h"
#include "Prefetch.h"

namespace shadow
{

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
  std::vector<std::uint32_t>& mixed = *facing.mixedWords;
  mixed.clear();
  geometry.getClusterTree().classify(decider.getScaledLight(), facing.towards, facing.away, mixed);
  constexpr std::size_t ahead = 8;
  std::vector<std::uint32_t> doubtful;
  for (std::size_t index = 0; index < mixed.size(); ++index)
  {
    if (index + ahead < mixed.size())
    {
      prefetch(&geometry.getPlaneBlocks()[mixed[index + ahead]], sizeof(PlaneBlock));
    }
    decider.compare(mixed[index], std::size_t{mixed[index]} + 1, facing, doubtful);
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
