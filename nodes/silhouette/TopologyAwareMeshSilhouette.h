#pragma once

#include "SilhouetteFinder.h"

namespace shadow
{

/// Lets every triangle compare its own side with those of its three neighbours, as a topology-aware mesh does
/// that is drawn from the light (TAM).
///
/// A triangle owns the edges to neighbours that are more averted than itself: one that faces the light owns
/// those to triangles that do not; where every triangle casts, one with the light in its plane owns those to
/// averted ones. A border is owned by its only triangle. The published form evaluates the stored normals of
/// the neighbours; here both sides are read from the facing bits, so that what normals leave in doubt is
/// exact, and neighbours never disagree.
///
/// @par Cost    O(triangles); reads 12 bytes and up to eight bits a triangle that may own an edge
/// @par Memory  24 bytes a triangle, prepared once for a geometry, see TopologyAwareMesh
/// @par Source  Valient, "Hardware Generated Object Silhouettes", sections 3.1 and 4
class TopologyAwareMeshSilhouette : public SilhouetteFinder
{
public:
  std::vector<SilhouetteEdge> find(const SEDGeometry& geometry, const LightFacing& facing,
                                   Casting casting) const override;
};

} // namespace shadow
