#include "TriangularSilhouette.h"

#include "CastingTriangles.h"
#include "DirectedEdgeSet.h"

namespace shadow
{

std::vector<SilhouetteEdge> TriangularSilhouette::find(const SEDGeometry& geometry, const LightFacing& facing,
                                                       Casting casting) const
{
  DirectedEdgeSet edges;
  forEachCastingTriangle(geometry, facing, casting, nullptr,
                         [&edges](std::uint32_t a, std::uint32_t b, std::uint32_t c)
                         { edges.addTriangle(a, b, c); });
  return edges.getEdges();
}

} // namespace shadow
