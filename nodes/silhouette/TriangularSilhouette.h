#pragma once

#include "SilhouetteFinder.h"

namespace shadow
{

/// Puts the directed edges of the casting triangles into a set in which opposite ones cancel; what is left is
/// the silhouette (TA, the triangular algorithm).
///
/// The published form searches a list; here it is a hash table. It needs the triangles alone, no adjacency.
///
/// @par Cost    O(triangles / 64 + casting triangles); reads 12 bytes and three slots a casting triangle
/// @par Source  Kolivand & Sunar 2011, "Hybrid Silhouette Detection for Real-Time Shadow Volume", chapter IV
class TriangularSilhouette : public SilhouetteFinder
{
public:
  std::vector<SilhouetteEdge> find(const SEDGeometry& geometry, const LightFacing& facing,
                                   Casting casting) const override;
};

} // namespace shadow
