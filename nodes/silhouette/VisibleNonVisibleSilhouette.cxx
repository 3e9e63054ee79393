#include "VisibleNonVisibleSilhouette.h"

#include <cstdint>

#include "CastingTriangles.h"

namespace shadow
{

namespace
{

/// The neighbours of an edge that cast, apart by the way in which they run through it.
class NeighbourCounter
{
public:
  NeighbourCounter(const LightFacing& theFacing, Casting casting)
      : facing(theFacing), everyTriangle(casting == Casting::EveryTriangle)
  {
  }

  /// How many more run through the edge as @p first does than against it. Two neighbours that both face the
  /// light cancel, so that exactly one of them leaves 1 or -1.
  int count(std::uint32_t first, std::uint32_t second) const
  {
    int forwards = this->visible(first);
    int backwards = 0;
    if (second != noTriangle)
    {
      backwards += this->visible(second);
    }
    if (this->everyTriangle)
    {
      backwards += this->hidden(first);
      forwards += second != noTriangle ? this->hidden(second) : 0;
    }
    return forwards - backwards;
  }

private:
  int visible(std::uint32_t triangle) const { return this->facing.towards.test(triangle) ? 1 : 0; }
  int hidden(std::uint32_t triangle) const { return this->facing.away.test(triangle) ? 1 : 0; }

  const LightFacing& facing;
  bool everyTriangle;
};

} // namespace

std::vector<SilhouetteEdge> VisibleNonVisibleSilhouette::find(const SEDGeometry& geometry,
                                                              const LightFacing& facing,
                                                              Casting casting) const
{
  const NeighbourCounter neighbours(facing, casting);
  std::vector<SilhouetteEdge> silhouette;
  forEachEdge(geometry.getEdgeTable(), [&](std::uint32_t first, std::uint32_t side, std::uint32_t second)
              { addSide(geometry, first, side, neighbours.count(first, second), silhouette); });
  return silhouette;
}

} // namespace shadow
