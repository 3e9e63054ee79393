#pragma once

#include <cstddef>

#include "BruteForceSilhouette.h"
#include "HierarchicalSilhouette.h"

namespace shadow
{

/// The method that is faster for a mesh of its size: BruteForceSilhouette for small ones, else
/// HierarchicalSilhouette.
class AutoSilhouette : public SilhouetteFinder
{
public:
  /// Triangles from which on the hierarchical method is faster. Measured with bench_silhouette: with 8,000 it
  /// is ahead by a tenth on a smooth mesh and level on one that is dented everywhere; with 4,000 it is
  /// behind by a tenth on both.
  static constexpr std::size_t leastHierarchical = 8000;

  SilhouetteMethod getMethod(const SEDGeometry& geometry) const override;
  void face(const SEDGeometry& geometry, const glm::dvec4& lightMC, LightFacing& facing) const override;
  std::vector<SilhouetteEdge> find(const SEDGeometry& geometry, const LightFacing& facing,
                                   Casting casting) const override;

private:
  const SilhouetteFinder& choose(const SEDGeometry& geometry) const;

  BruteForceSilhouette bruteForce;
  HierarchicalSilhouette hierarchical;
};

} // namespace shadow
