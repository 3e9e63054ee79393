#include "GPUFacingBound.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "FacingDecider.h"

namespace shadow
{

namespace
{

/// Of one step with numbers that are sums of two floats.
constexpr double step = 0x1p-48;

/// A light this close to a corner counts as at it, in units of the frame: facing.glsl says 3e-14, in 48 bits.
constexpr double atCorner = 0x1p-44;

/// Steps from the corners to the sign, each relative to the largest term: 2 for each side and 8 for their
/// product, 4 for the normal, 2 for the arm, 8 for its product with the normal, 4 for the sum. 32 leave room.
constexpr double steps = 32.0;

double sumOfSizes(const glm::dvec3& vector)
{
  return std::abs(vector.x) + std::abs(vector.y) + std::abs(vector.z);
}

/// Frobenius.
double normOf(const glm::dmat3& matrix)
{
  return std::sqrt(glm::dot(matrix[0], matrix[0]) + glm::dot(matrix[1], matrix[1]) +
                   glm::dot(matrix[2], matrix[2]));
}

} // namespace

GPUFacingBound GPUFacingBound::inModel(const SEDGeometry& geometry, const glm::dvec4& lightMC)
{
  GPUFacingBound bound;
  // The frame's unit is below twice the reach.
  bound.light = step * sumOfSizes(lightMC) + 2.0 * atCorner * lightMC.w * geometry.getReach();
  return bound;
}

GPUFacingBound GPUFacingBound::inScene(const SEDGeometry& geometry, const glm::dmat4& modelToWorld,
                                       const SceneFrame& frame, const Light& light,
                                       const glm::dvec4& lightMC)
{
  GPUFacingBound bound;
  bound.linear = glm::dmat3(modelToWorld);
  const double size = normOf(bound.linear);
  const double condition = size * normOf(glm::inverse(bound.linear));
  const double reach = geometry.getReach();
  const double w = lightMC.w;
  const glm::dvec3 translation(modelToWorld[3]);
  const glm::dvec3 position(light.positionWC);
  // Coordinates are at most 2 in the frame. What double precision rounds is relative to all terms of a sum.
  bound.corner = 2.0 * step * frame.unit + 0x1p-50 * size * reach;
  // Of a direction, which length it has does not matter.
  const double rounded = w != 0.0 ? sumOfSizes(position - frame.originWC) : size * sumOfSizes(lightMC);
  const double transformed = w != 0.0 ? sumOfSizes(position) + sumOfSizes(translation) : rounded;
  bound.light = step * rounded + 0x1p-50 * condition * transformed +
                0x1p-50 * size * (sumOfSizes(lightMC) + w * (sumOfSizes(geometry.getOrigin()) + reach)) +
                w * (atCorner * frame.unit + 0x1p-50 * sumOfSizes(frame.originWC));
  return bound;
}

double GPUFacingBound::getMargin(const SEDGeometry& geometry, double w) const
{
  // isSure() in model space, of the triangle that it is hardest for, generously: a linear map makes a volume
  // at least its determinant times as large, which is at least 1 / inverse^3.
  const double inverse = normOf(glm::inverse(this->linear));
  const double condition = normOf(this->linear) * inverse;
  const double sharpness = geometry.getSharpness();
  const double reach = geometry.getReach();
  return 2.0 * inverse * this->light / (w != 0.0 ? reach : 1.0) +
         16.0 * condition * condition * sharpness * inverse * this->corner / reach +
         8.0 * steps * step * condition * condition * condition * sharpness;
}

bool GPUFacingBound::isSure(const SEDGeometry& geometry, std::uint32_t triangle,
                            const glm::dvec4& lightMC) const
{
  const std::array<std::uint32_t, 3>& corners = geometry.getTriangles()[triangle];
  const auto at = [&](std::size_t place) { return glm::dvec3(geometry.getPositions()[corners[place]]); };
  const glm::dvec3 toSecond = at(1) - at(0);
  const glm::dvec3 toThird = at(2) - at(0);
  if (glm::cross(toSecond, toThird) == glm::dvec3(0.0))
  {
    return true;
  }
  const glm::dvec3 u = this->linear * toSecond;
  const glm::dvec3 v = this->linear * toThird;
  const glm::dvec3 arm = this->linear * (glm::dvec3(lightMC) - lightMC.w * at(0));
  const glm::dvec3 normal = glm::cross(u, v);
  const glm::dvec3 products = glm::abs(glm::dvec3(u.y * v.z, u.z * v.x, u.x * v.y)) +
                              glm::abs(glm::dvec3(u.z * v.y, u.x * v.z, u.y * v.x));
  const double doubt = steps * step * glm::dot(products, glm::abs(arm)) +
                       2.0 * this->corner * (sumOfSizes(u) + sumOfSizes(v)) * sumOfSizes(arm) +
                       (this->light + lightMC.w * this->corner) * sumOfSizes(normal);
  return std::abs(glm::dot(normal, arm)) > doubt;
}

bool computeFacing(const SEDGeometry& geometry, const glm::dvec4& lightMC, const GPUFacingBound& bound,
                   LightFacing& facing)
{
  FacingDecider decider(geometry, lightMC);
  if (!decider.isLit())
  {
    computeFacing(geometry, lightMC, facing);
    return true;
  }
  decider.widenDoubt(bound.getMargin(geometry, lightMC.w));
  std::vector<std::uint32_t> doubtful;
  decider.compareClusters(facing, doubtful);
  decider.resolve(doubtful, facing);
  return std::all_of(doubtful.begin(), doubtful.end(), [&](std::uint32_t triangle)
                     { return bound.isSure(geometry, triangle, lightMC); });
}

} // namespace shadow
