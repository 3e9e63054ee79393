#include "VisibleNonVisibleSilhouette.h"

#include <cstdint>

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

  /// How many more run through the edge forwards than backwards. Two neighbours that both face the light
  /// cancel, so that exactly one of them leaves 1 or -1.
  int count(const Edge& edge) const
  {
    int forwards = this->visible(edge.triangles[0]);
    int backwards = 0;
    if (edge.triangles[1] != noTriangle)
    {
      backwards += this->visible(edge.triangles[1]);
    }
    if (this->everyTriangle)
    {
      backwards += this->hidden(edge.triangles[0]);
      forwards += edge.triangles[1] != noTriangle ? this->hidden(edge.triangles[1]) : 0;
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
  for (const Edge& edge : geometry.getEdges())
  {
    const int runs = neighbours.count(edge);
    if (runs > 0)
    {
      silhouette.push_back({edge.vertices[0], edge.vertices[1], static_cast<std::uint32_t>(runs)});
    }
    else if (runs < 0)
    {
      silhouette.push_back({edge.vertices[1], edge.vertices[0], static_cast<std::uint32_t>(-runs)});
    }
  }
  return silhouette;
}

} // namespace shadow
