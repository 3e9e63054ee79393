#include "SceneFrame.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

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

/// To the nearest double that a float holds. On the bits: GCC 12 takes a conversion to float and back for
/// nothing where it vectorises two of them (x - double(float(x)) became 0).
double roundToFloat(double value)
{
  constexpr int more = std::numeric_limits<double>::digits - std::numeric_limits<float>::digits;
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  bits += std::uint64_t{1} << (more - 1);
  bits &= ~((std::uint64_t{1} << more) - 1);
  std::memcpy(&value, &bits, sizeof(bits));
  return value;
}

} // namespace

SplitVector split(const glm::dvec3& value)
{
  const glm::dvec3 high(roundToFloat(value.x), roundToFloat(value.y), roundToFloat(value.z));
  return {glm::vec3(high), glm::vec3(value - high)};
}

double SceneFrame::reachOf(const glm::dvec3& lowerWC, const glm::dvec3& upperWC) const
{
  return std::max(largestCoordinate(lowerWC - this->originWC), largestCoordinate(upperWC - this->originWC));
}

SceneFrame SceneFrame::around(const glm::dvec3& lowerWC, const glm::dvec3& upperWC)
{
  SceneFrame frame;
  frame.originWC = chooseGridOrigin(lowerWC, upperWC);
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
