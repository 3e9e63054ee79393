#pragma once

#include <array>
#include <cstddef>

#include <glm/glm.hpp>

namespace shadow
{

/// Planes of the 64 triangles of one word of FacingBits: dot((x, y, z), p) + offset > 0 in front of them, for
/// p relative to the geometry's origin and in units of its reach.
///
/// The normals have unit length, so that those of a smooth patch are nearly equal, and |offset| is below 1. A
/// coordinate is off by less than 1.5 * 2^-24. A triangle whose plane is not known as well as that, one
/// without area above all, and one that is not there have a plane of zeros: it decides nothing.
struct PlaneBlock
{
  static constexpr std::size_t triangles = 64;

  /// Where the plane of a triangle stands. Eight planes that stand together give one bit of each of the eight
  /// bytes of a word, so that comparing vectors of eight makes bits without moving them.
  static constexpr std::size_t slotOf(std::size_t bit) { return 8 * (bit % 8) + bit / 8; }

  std::array<float, triangles> x{};
  std::array<float, triangles> y{};
  std::array<float, triangles> z{};
  std::array<float, triangles> offset{};
};

/// A light in the scale of the planes, and how far a plane's value at it may be off.
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
  /// the sign of the exact one, and no corner of its triangle is the light rounded to single precision.
  ///
  /// With e = 2^-24 and S = |x| + |y| + |z| + |w|: the plane is off by 1.5 e a coordinate, the light by 1 e,
  /// and evaluating adds 3 e. At a corner that single precision cannot tell from the light the exact value is
  /// below 1 e S. The sum is 6.5 e S; the bound is 8 e S, and room for underflow.
  float bound = 0.0f;
};

/// @param lightMC  w = 1: position relative to the geometry's origin; w = 0: direction towards the light
/// @param reach    a power of two, see SEDGeometry::getReach()
/// @return  all zeros when the light has no direction or is not finite
ScaledLight scaleLight(const glm::dvec4& lightMC, double reach);

} // namespace shadow
