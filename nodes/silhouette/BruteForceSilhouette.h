#pragma once

#include "SilhouetteFinder.h"

namespace shadow
{

/// Looks at every edge once: it is on the silhouette when the facing of its triangles differs.
///
/// @par Cost    O(edges); reads 16 bytes a triangle for its facing, and 2 to 5 bytes and two bits an edge
/// @par Source  Shi 2006, chapter 3.2; Crow 1977, "Shadow Algorithms for Computer Graphics"
class BruteForceSilhouette : public SilhouetteFinder
{
public:
  std::vector<SilhouetteEdge> find(const SEDGeometry& geometry, const LightFacing& facing,
                                   Casting casting) const override;
};

} // namespace shadow
