#include "HierarchicalSilhouette.h"

#include <cstdint>
#include <vector>

#include "EdgeScan.h"
#include "FacingDecider.h"

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
  std::vector<std::uint32_t> doubtful;
  decider.compareClusters(facing, doubtful);
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
