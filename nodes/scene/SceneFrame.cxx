#include "SceneFrame.h"

#include <algorithm>
#include <cmath>

#include "GridOrigin.h"

namespace shadow
{

namespace
{

double largestCoordinate(const glm::dvec3& vector)
{
  return std::max({std::abs(vector.x), std::abs(vector.y), std::abs(vector.z)});
}

/// The smallest power of two that is not smaller; 1 for zero.
double powerOfTwoAbove(double value)
{
  return value > 0.0 ? std::exp2(std::ceil(std::log2(value))) : 1.0;
}

} // namespace

SplitVector split(const glm::dvec3& value)
{
  const glm::vec3 high(value);
  return {high, glm::vec3(value - glm::dvec3(high))};
}

double SceneFrame::reachOf(const glm::dvec3& lowerWC, const glm::dvec3& upperWC) const
{
  return std::max(largestCoordinate(lowerWC - this->originWC), largestCoordinate(upperWC - this->originWC));
}

SceneFrame SceneFrame::around(const glm::dvec3& lowerWC, const glm::dvec3& upperWC)
{
  SceneFrame frame;
  frame.originWC = nearestGridPoint(0.5 * lowerWC + 0.5 * upperWC, upperWC - lowerWC);
  frame.unit = powerOfTwoAbove(frame.reachOf(lowerWC, upperWC));
  return frame;
}

bool SceneFrame::suits(const glm::dvec3& lowerWC, const glm::dvec3& upperWC) const
{
  const double reach = this->reachOf(lowerWC, upperWC);
  return reach <= 2.0 * this->unit && reach > 0.125 * this->unit;
}

std::optional<SceneLight> lightToScene(const Light& light, const SceneFrame& frame)
{
  const double w = light.positionWC.w == 0.0 ? 0.0 : 1.0;
  const glm::dvec3 positionOrDirection = (glm::dvec3(light.positionWC) - w * frame.originWC) / frame.unit;
  const double length = largestCoordinate(positionOrDirection);
  if (!std::isfinite(positionOrDirection.x + positionOrDirection.y + positionOrDirection.z))
  {
    return std::nullopt;
  }
  const double scale = w == 0.0 || length > 1.0 ? powerOfTwoAbove(length) : 1.0;
  SceneLight result;
  result.position = split(positionOrDirection / scale);
  result.w = static_cast<float>(w / scale);
  return result;
}

} // namespace shadow
