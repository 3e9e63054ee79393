#include "BruteForceSilhouette.h"

#include "EdgeScan.h"

namespace shadow
{

std::vector<SilhouetteEdge> BruteForceSilhouette::find(const SEDGeometry& geometry, const LightFacing& facing,
                                                       Casting casting) const
{
  return scanEdges(geometry, facing, casting, nullptr);
}

} // namespace shadow
