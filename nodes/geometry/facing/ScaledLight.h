#pragma once

#include <cstdint>

#include <glm/glm.hpp>

namespace shadow
{

/// A light in the scale of PlaneBlock, and how far a plane's value at it may be off.
///
/// Multiplied by a power of two so that the largest coordinate lies in [1/2, 1), which leaves every sign as
/// it is.
struct ScaledLight
{
  float x = 0.0f;
  float y = 0.0f;
  float z = 0.0f;
  float w = 0.0f;

  /// A plane's value beyond this, x * X + y * Y + z * Z + offset * W in single precision in any order, has
  /// the sign of the exact one.
  ///
  /// With u = 1 / PlaneBlock::unitsInOne, e = 2^-24 and S = |x| + |y| + |z| + |w|: the plane is off by u / 2
  /// a coordinate and by less than 1 e more, the light by 1 e, and evaluating adds 3 e. The sum is
  /// (u / 2 + 5 e) S; the bound is (u / 2 + 16 e) S, and room for underflow.
  float bound = 0.0f;
};

/// @param lightMC  w = 1: position relative to the geometry's origin; w = 0: direction towards the light
/// @param reach    a power of two, see SEDGeometry::getReach()
/// @return  all zeros when the light has no direction, down to rounding, or is not finite
ScaledLight scaleLight(const glm::dvec4& lightMC, double reach);

/// The same in whole numbers, so that the products with a plane of units fit into 32 bits and their sum too.
struct LightInUnits
{
  std::int16_t x = 0;
  std::int16_t y = 0;
  std::int16_t z = 0;
  std::int16_t w = 0;
  std::int32_t bound = 0; ///< as ScaledLight::bound, for values in whole numbers
};

/// @return  all zeros for a light of all zeros
LightInUnits toUnits(const ScaledLight& light);

} // namespace shadow
