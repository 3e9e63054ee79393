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
  /// Triangles from which on the hierarchical method is faster. Measured with bench_silhouette and
  /// bench_published_silhouettes: with 16,000 it is level on a smooth mesh, with 13,000 behind by a fifth on
  /// one with flat parts, with 65,000 ahead by a fifth on a smooth mesh and level on the bunny.
  static constexpr std::size_t leastHierarchical = 16000;

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
