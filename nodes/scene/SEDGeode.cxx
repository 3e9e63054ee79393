#include "SEDGeode.h"

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "SweepUnused.h"

namespace shadow
{

void SEDGeode::accept(NodeVisitor& visitor)
{
  visitor.enter(*this, [&] { visitor.apply(*this); });
}

PathState& SEDGeode::getPathState(const NodePath& path)
{
  PathState& state = this->paths[path];
  state.used = true;
  return state;
}

void SEDGeode::dropUnusedPaths()
{
  sweepUnused(this->paths);
}

std::size_t SEDGeode::countVolumes() const
{
  std::size_t volumes = 0;
  for (const auto& path : this->paths)
  {
    for (const auto& light : path.second.lights)
    {
      volumes += light.second.extruded ? 1 : 0;
    }
  }
  return volumes;
}

std::size_t SEDGeode::getMemorySize() const
{
  std::size_t bytes = 0;
  for (const auto& path : this->paths)
  {
    bytes += path.second.reachableBits.capacity() * sizeof(glm::uvec2);
    for (const auto& [index, light] : path.second.lights)
    {
      (void)index;
      bytes += 8 * (light.facing.towards.getWords().capacity() + light.facing.away.getWords().capacity());
      bytes += light.facing.mixedWords ? 4 * light.facing.mixedWords->capacity() : 0;
      for (const ShadowVolume& volume : light.volumes)
      {
        bytes += volume.getTriangleCount() * sizeof(ShadowVolume::Triangle);
      }
    }
  }
  return bytes;
}

BoxCorners worldCorners(const SEDGeometry& geometry, const glm::dmat4& modelToWorld)
{
  BoxCorners corners;
  for (unsigned i = 0; i < 8; ++i)
  {
    const glm::dvec3 choose(i & 1u, (i >> 1) & 1u, (i >> 2) & 1u);
    const glm::dvec3 corner =
        geometry.getOrigin() + glm::mix(geometry.getLowerBound(), geometry.getUpperBound(), choose);
    corners[i] = glm::dvec3(modelToWorld * glm::dvec4(corner, 1.0));
  }
  return corners;
}

glm::dmat4 worldFromRelative(const SEDGeometry& geometry, const glm::dmat4& modelToWorld)
{
  return glm::translate(modelToWorld, geometry.getOrigin());
}

glm::dvec4 farPlaneToModel(const glm::dvec4& planeWC, const glm::dmat4& wcFromRelative)
{
  // A plane goes the other way: as a row vector from the left.
  const glm::dvec4 planeMC = planeWC * wcFromRelative;
  return planeMC / std::max(glm::length(glm::dvec3(planeMC)), std::abs(planeMC.w));
}

bool isInvertible(const glm::dmat4& modelToWorld)
{
  // Scale-free test: a matrix of tiny or huge scale is fine, one that flattens is not.
  const glm::dmat3 linear(modelToWorld);
  const double scale = glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2]);
  const double determinant = glm::determinant(linear);
  const glm::dvec3 translation(modelToWorld[3]);
  return std::isfinite(determinant) && std::abs(determinant) > 1e-14 * scale && determinant != 0.0 &&
         std::isfinite(translation.x + translation.y + translation.z);
}

std::optional<glm::dvec4> lightToModel(const Light& light, const glm::dmat4& modelToWorld,
                                       const glm::dvec3& origin)
{
  if (!isInvertible(modelToWorld))
  {
    return std::nullopt;
  }
  const glm::dmat3 linear(modelToWorld);
  const glm::dmat3 inverse = glm::inverse(linear);
  const glm::dvec3 translation(modelToWorld[3]);
  const glm::dvec3 position(light.positionWC);
  const double w = light.positionWC.w;
  glm::dvec3 lightMC = inverse * (position - translation * w) - origin * w;
  if (w == 0.0)
  {
    lightMC = glm::normalize(lightMC);
  }
  return glm::dvec4(lightMC, w);
}

} // namespace shadow
