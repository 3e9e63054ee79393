#include <cstddef>

#include "FacingDecider.h"
#include "ShadowVolume.h"

namespace shadow
{

namespace
{

/// How far outside its bounding box a point light has to be to count as outside, relative to the box.
constexpr double boxMargin = 1e-6;

bool isInsideBox(const SEDGeometry& geometry, const glm::dvec3& lightMC)
{
  const glm::dvec3& lower = geometry.getLowerBound();
  const glm::dvec3& upper = geometry.getUpperBound();
  const double margin = boxMargin * glm::length(upper - lower);
  for (int axis = 0; axis < 3; ++axis)
  {
    // Written so that a light that is not a number is not outside either.
    if (lightMC[axis] < lower[axis] - margin || lightMC[axis] > upper[axis] + margin)
    {
      return false;
    }
  }
  return true;
}

} // namespace

void computeFacing(const SEDGeometry& geometry, const glm::dvec4& lightMC, LightFacing& facing)
{
  const std::size_t triangles = geometry.getTriangles().size();
  facing.mixedWords.reset();
  const FacingDecider decider(geometry, lightMC);
  if (!decider.isLit())
  {
    facing.towards.assign(triangles);
    facing.away.assign(triangles);
    return;
  }
  facing.towards.resize(triangles);
  facing.away.resize(triangles);
  decider.decide(0, geometry.getPlaneBlocks().size(), facing);
}

LightFacing computeFacing(const SEDGeometry& geometry, const glm::dvec4& lightMC)
{
  LightFacing facing;
  computeFacing(geometry, lightMC, facing);
  return facing;
}

Casting chooseCasting(const SEDGeometry& geometry, const glm::dvec4& lightMC)
{
  const bool outside = lightMC.w == 0.0 || !isInsideBox(geometry, glm::dvec3(lightMC));
  return geometry.isClosed() && outside ? Casting::LightFacing : Casting::EveryTriangle;
}

} // namespace shadow
