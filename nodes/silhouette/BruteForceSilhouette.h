#pragma once

#include <utility>
#include <vector>

#include "ParallelFor.h"
#include "SilhouetteFinder.h"

namespace shadow
{

/// Looks at every triangle and every edge once: an edge is on the silhouette when the facing of its triangles
/// differs.
///
/// @par Cost    O(triangles + edges); reads 16 bytes a triangle for its facing, and 2 to 5 bytes and two bits
/// an edge
/// @par Source  Shi 2006, chapter 3.2; Crow 1977, "Shadow Algorithms for Computer Graphics"
class BruteForceSilhouette : public SilhouetteFinder
{
public:
  /// @param theParallelFor  used from 260,000 triangles on; below, threads cost more than they gain
  explicit BruteForceSilhouette(ParallelFor theParallelFor = {}) : parallelFor(std::move(theParallelFor)) {}

  void face(const SEDGeometry& geometry, const glm::dvec4& lightMC, LightFacing& facing) const override;

  std::vector<SilhouetteEdge> find(const SEDGeometry& geometry, const LightFacing& facing,
                                   Casting casting) const override;

private:
  bool isParallel(const SEDGeometry& geometry) const;

  ParallelFor parallelFor;
};

} // namespace shadow
