#include "CountableVolumes.h"

namespace shadow
{

std::vector<ShadowVolume> makeCountableVolumes(const SEDGeometry& geometry, const SilhouetteFinder& finder,
                                               const LightFacing& facing, const glm::dvec4& lightMC,
                                               const ShadowVolumeOptions& options)
{
  const Casting casting = chooseCasting(geometry, lightMC);
  const std::vector<SilhouetteEdge> silhouette = finder.find(geometry, facing, casting);
  std::vector<ShadowVolume> volumes;
  volumes.push_back(extrudeSilhouette(geometry, silhouette, facing, casting, lightMC, options));
  return volumes;
}

} // namespace shadow
