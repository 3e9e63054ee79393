#pragma once

#include <cstdint>
#include <vector>

#include "SEDGeometry.h"
#include "ShadowVolume.h"

namespace shadow
{

/// The silhouette, found by comparing the bits of the two triangles of each edge. See
/// SilhouetteFinder::find().
///
/// @param words  null, or the only words (rising) that can hold an edge between triangles that differ
/// @par Cost     O(edges of the words + borders); see EdgeKernel
std::vector<SilhouetteEdge> scanEdges(const SEDGeometry& geometry, const LightFacing& facing, Casting casting,
                                      const std::vector<std::uint32_t>* words);

} // namespace shadow
