#include "BruteForceSilhouette.h"

#include <cstdint>

namespace shadow
{

namespace
{

/// 1 when the triangle casts as it is oriented, -1 when it casts turned over, 0 when it does not cast.
int getSign(const LightFacing& facing, std::uint32_t triangle)
{
  return static_cast<int>(facing.towards.test(triangle)) - static_cast<int>(facing.away.test(triangle));
}

std::vector<SilhouetteEdge> findLightFacing(const SEDGeometry& geometry, const LightFacing& facing)
{
  std::vector<SilhouetteEdge> silhouette;
  for (const Edge& edge : geometry.getEdges())
  {
    const bool first = facing.towards.test(edge.triangles[0]);
    const bool second = edge.triangles[1] != noTriangle && facing.towards.test(edge.triangles[1]);
    if (first && !second)
    {
      silhouette.push_back({edge.vertices[0], edge.vertices[1], 1});
    }
    else if (second && !first)
    {
      silhouette.push_back({edge.vertices[1], edge.vertices[0], 1});
    }
  }
  return silhouette;
}

/// Sums over the triangles of an edge how they run through it, each turned to the light.
std::vector<SilhouetteEdge> findEveryTriangle(const SEDGeometry& geometry, const LightFacing& facing)
{
  std::vector<SilhouetteEdge> silhouette;
  for (const Edge& edge : geometry.getEdges())
  {
    const int first = getSign(facing, edge.triangles[0]);
    const int sum = edge.triangles[1] == noTriangle ? first : first - getSign(facing, edge.triangles[1]);
    if (sum > 0)
    {
      silhouette.push_back({edge.vertices[0], edge.vertices[1], static_cast<std::uint32_t>(sum)});
    }
    else if (sum < 0)
    {
      silhouette.push_back({edge.vertices[1], edge.vertices[0], static_cast<std::uint32_t>(-sum)});
    }
  }
  return silhouette;
}

} // namespace

std::vector<SilhouetteEdge> BruteForceSilhouette::find(const SEDGeometry& geometry, const LightFacing& facing,
                                                       Casting casting) const
{
  return casting == Casting::LightFacing ? findLightFacing(geometry, facing)
                                         : findEveryTriangle(geometry, facing);
}

} // namespace shadow
