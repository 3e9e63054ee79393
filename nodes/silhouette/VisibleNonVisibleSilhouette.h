#pragma once

#include "SilhouetteFinder.h"

namespace shadow
{

/// Counts, for every edge, the neighbours that face the light; an edge with exactly one is on the silhouette
/// (VnV, the visible-non-visible algorithm).
///
/// The published form looks for the neighbours among all faces; here the adjacency names them, and what is
/// left is close to BruteForceSilhouette. Where every triangle casts, those that face away count as well,
/// turned over.
///
/// @par Cost    O(edges); reads 2 to 5 bytes and two bits an edge
/// @par Source  Kolivand & Sunar 2011, "Hybrid Silhouette Detection for Real-Time Shadow Volume", chapter IV
class VisibleNonVisibleSilhouette : public SilhouetteFinder
{
public:
  std::vector<SilhouetteEdge> find(const SEDGeometry& geometry, const LightFacing& facing,
                                   Casting casting) const override;
};

} // namespace shadow
