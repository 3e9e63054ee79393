#pragma once

#include "SilhouetteFinder.h"

namespace shadow
{

/// As TriangularSilhouette, but each flat region is one polygon: its inner edges, and their tests, are gone
/// (HSD, hybrid silhouette detection).
///
/// A polygon's facing is read from the bits of its triangles, whole words at a time. Where they disagree, as
/// beside a vertex at the light or where a volume is divided, its triangles are taken one by one. The edges
/// found are therefore those of the facing handed in, whatever the tolerance.
///
/// @par Cost    O(triangles / 64 + casting triangles outside flat regions + borders of casting regions)
/// @par Memory  about 8 bytes a border edge of a region, prepared once for a geometry and tolerance
/// @par Source  Kolivand & Sunar 2011, "Hybrid Silhouette Detection for Real-Time Shadow Volume", chapter V
class HybridSilhouette : public SilhouetteFinder
{
public:
  /// @param coplanarTolerance  degrees, see findFlatRegions()
  explicit HybridSilhouette(double coplanarTolerance = 0.0) : tolerance(coplanarTolerance) {}

  std::vector<SilhouetteEdge> find(const SEDGeometry& geometry, const LightFacing& facing,
                                   Casting casting) const override;

  /// With a tolerance: every triangle of a region faces as the region's representative does, but for those
  /// that do not cast. Nothing without one: exactly coplanar triangles agree as they are.
  std::optional<LightFacing> simplifyFacing(const SEDGeometry& geometry,
                                            const LightFacing& facing) const override;

private:
  double tolerance;
};

} // namespace shadow
