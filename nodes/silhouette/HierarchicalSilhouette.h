#pragma once

#include "SilhouetteFinder.h"

namespace shadow
{

/// Skips clusters of triangles that face the light as one, by the geometry's ClusterTree, and looks at the
/// planes and edges of the others only. The same bits and edges as BruteForceSilhouette.
///
/// @par Cost    O(clusters that the silhouette runs through + borders), and two stores for 64 triangles. On a
/// smooth mesh that is the square root of the number of triangles; on one that is dented everywhere it is
/// that number
/// @par Source  Johnson & Cohen 2001, "Spatialized Normal Cone Hierarchies"; Sander et al. 2000, "Silhouette
///              Clipping"; see ClusterTree.h
class HierarchicalSilhouette : public SilhouetteFinder
{
public:
  void face(const SEDGeometry& geometry, const glm::dvec4& lightMC, LightFacing& facing) const override;

  /// Fast for what face() has written; any other facing is looked at as BruteForceSilhouette does.
  std::vector<SilhouetteEdge> find(const SEDGeometry& geometry, const LightFacing& facing,
                                   Casting casting) const override;
};

} // namespace shadow
