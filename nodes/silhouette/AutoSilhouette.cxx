#include "AutoSilhouette.h"

namespace shadow
{

SilhouetteMethod AutoSilhouette::getMethod(const SEDGeometry& geometry) const
{
  return geometry.getTriangles().size() < leastHierarchical ? SilhouetteMethod::BruteForce
                                                            : SilhouetteMethod::Hierarchical;
}

const SilhouetteFinder& AutoSilhouette::choose(const SEDGeometry& geometry) const
{
  if (this->getMethod(geometry) == SilhouetteMethod::BruteForce)
  {
    return this->bruteForce;
  }
  return this->hierarchical;
}

void AutoSilhouette::face(const SEDGeometry& geometry, const glm::dvec4& lightMC, LightFacing& facing) const
{
  this->choose(geometry).face(geometry, lightMC, facing);
}

std::vector<SilhouetteEdge> AutoSilhouette::find(const SEDGeometry& geometry, const LightFacing& facing,
                                                 Casting casting) const
{
  return this->choose(geometry).find(geometry, facing, casting);
}

} // namespace shadow
