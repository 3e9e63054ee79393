#include "TopologyAwareMeshSilhouette.h"

#include <cstdint>
#include <memory>

#include "CastingTriangles.h"
#include "TopologyAwareMesh.h"

namespace shadow
{

std::vector<SilhouetteEdge> TopologyAwareMeshSilhouette::find(const SEDGeometry& geometry,
                                                              const LightFacing& facing,
                                                              Casting casting) const
{
  const auto mesh = geometry.getPreparedData().get<TopologyAwareMesh>(
      0.0, [&geometry] { return TopologyAwareMesh(geometry); });
  const auto sideOf = [&](std::uint32_t triangle) { return getCastingSign(facing, casting, triangle); };
  std::vector<SilhouetteEdge> silhouette;
  const auto addOwnedBy = [&](std::uint32_t triangle)
  {
    const int own = sideOf(triangle);
    for (std::uint32_t edge = 0; edge < 3; ++edge)
    {
      const std::uint32_t neighbour = mesh->getNeighbour(triangle, edge);
      const int other = neighbour == noTriangle ? 0 : sideOf(neighbour);
      if (neighbour == noTriangle || own > other)
      {
        addSide(geometry, triangle, edge, own - other, silhouette);
      }
    }
  };
  if (casting == Casting::LightFacing)
  {
    forEachTriangle(facing.towards, nullptr, addOwnedBy);
  }
  else
  {
    // All of them: one with the light in its plane may own edges, and an averted one its borders.
    for (std::uint32_t triangle = 0; triangle < mesh->countFaces(); ++triangle)
    {
      addOwnedBy(triangle);
    }
  }
  return silhouette;
}

} // namespace shadow
