#include "ScaledLight.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "PlaneBlock.h"

namespace shadow
{

ScaledLight scaleLight(const glm::dvec4& lightMC, double reach)
{
  const glm::dvec4 inReach(glm::dvec3(lightMC), lightMC.w * reach);
  const glm::dvec4 size = glm::abs(inReach);
  const double largest = std::max({size.x, size.y, size.z, size.w});
  const double sum = size.x + size.y + size.z + size.w;
  if (!(largest > 0.0) || !std::isfinite(sum))
  {
    return {};
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  const double factor = std::ldexp(1.0, -exponent);
  if (!std::isfinite(factor))
  {
    return {};
  }
  const glm::dvec4 scaled = inReach * factor;
  constexpr double halfUnit = 0.5 / PlaneBlock::unitsInOne;
  const double bound = (halfUnit + 16.0 * 0x1p-24) * sum * factor + 0x1p-100;
  return {static_cast<float>(scaled.x), static_cast<float>(scaled.y), static_cast<float>(scaled.z),
          static_cast<float>(scaled.w), static_cast<float>(bound)};
}

LightInUnits toUnits(const ScaledLight& light)
{
  if (!(light.bound > 0.0f))
  {
    return {};
  }
  const glm::dvec4 exact(light.x, light.y, light.z, light.w);
  const double largest =
      std::max({std::abs(exact.x), std::abs(exact.y), std::abs(exact.z), std::abs(exact.w)});
  // A normal is no longer than unitsInOne + 1 and an offset no larger, so that no value comes to 2^31.
  const double most = glm::length(glm::dvec3(exact)) + std::abs(exact.w);
  const double factor = std::min(32767.0 / largest, 65000.0 / most);
  const glm::dvec4 rounded = glm::round(exact * factor);
  // The light is off by half a unit a coordinate, against normals of a length of 1 and offsets up to 1.
  constexpr double lightOff = 0.5 * 2.7321 * (PlaneBlock::unitsInOne + 2.0);
  const double bound =
      std::ceil(factor * PlaneBlock::unitsInOne * static_cast<double>(light.bound) + lightOff);
  constexpr double mostBound = std::numeric_limits<std::int32_t>::max();
  return {static_cast<std::int16_t>(rounded.x), static_cast<std::int16_t>(rounded.y),
          static_cast<std::int16_t>(rounded.z), static_cast<std::int16_t>(rounded.w),
          static_cast<std::int32_t>(std::min(bound, mostBound))};
}

} // namespace shadow
