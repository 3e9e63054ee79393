#pragma once

#include "SilhouetteFinder.h"

namespace shadow
{

/// Lets every triangle flip bits in the entries of its edges: F when it faces the light, B when it faces
/// away. An edge with both bits set is on the silhouette; on a border one of them is left.
///
/// The published buffer finds an entry through a list at the edge's lower vertex; here each triangle knows
/// its three entries. Beside F and B an entry notes the direction in which the flipping triangles run through
/// the edge, which a shadow volume needs to know.
///
/// @par Cost    O(triangles + edges); reads 12 bytes a triangle and 1 byte an edge
/// @par Memory  12 bytes a triangle, prepared once for a geometry; 1 byte an edge in each call
/// @par Source  Buchanan & Sousa 2000, "The Edge Buffer: A Data Structure for Easy Silhouette Rendering";
///              Shi 2006, chapter 2
class EdgeBufferSilhouette : public SilhouetteFinder
{
public:
  std::vector<SilhouetteEdge> find(const SEDGeometry& geometry, const LightFacing& facing,
                                   Casting casting) const override;
};

} // namespace shadow
