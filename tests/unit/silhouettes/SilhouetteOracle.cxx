#include "SilhouetteOracle.h"

#include <array>
#include <cstddef>
#include <cstdint>

#include "ExactSign.h"

namespace shadow::test
{

LightFacing faceExactly(const SEDGeometry& geometry, const glm::dvec4& light)
{
  const std::vector<glm::vec3>& p = geometry.getPositions();
  LightFacing facing;
  facing.towards.assign(geometry.getTriangles().size());
  facing.away.assign(geometry.getTriangles().size());
  for (std::size_t t = 0; t < geometry.getTriangles().size(); ++t)
  {
    const std::array<std::uint32_t, 3>& corners = geometry.getTriangles()[t];
    const int raster = exactSign(p[corners[0]], p[corners[1]], p[corners[2]], light);
    if (raster != 0)
    {
      ((raster > 0) != geometry.getReversed().test(t) ? facing.towards : facing.away).set(t);
    }
  }
  return facing;
}

EdgeBalance sumSides(const SEDGeometry& geometry, const LightFacing& facing, Casting casting)
{
  EdgeBalance sums;
  for (std::size_t t = 0; t < geometry.getTriangles().size(); ++t)
  {
    const bool away = casting == Casting::EveryTriangle && facing.away.test(t);
    if (facing.towards.test(t) || away)
    {
      sums.addTriangle(geometry.getTriangles()[t], away != geometry.getReversed().test(t) ? -1 : 1);
    }
  }
  return sums;
}

EdgeBalance sumSilhouette(const std::vector<SilhouetteEdge>& silhouette)
{
  EdgeBalance sums;
  for (const SilhouetteEdge& edge : silhouette)
  {
    sums.add(edge.from, edge.to, static_cast<int>(edge.multiplicity));
  }
  return sums;
}

} // namespace shadow::test
