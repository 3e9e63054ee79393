#pragma once

#include <glm/glm.hpp>

namespace shadow
{

/// Lights that one shadow mask holds: one bit each.
inline constexpr int maximumLights = 32;

/// A light that casts shadows. A spot light is a point light here: its cone is shading, not shadow.
struct Light
{
  int index = 0;              ///< bit in the shadow mask: place among the lights that are switched on
  glm::dvec4 positionWC{0.0}; ///< w = 1: position; w = 0: direction towards the light, any length but zero

  bool operator==(const Light& other) const
  {
    return this->index == other.index && this->positionWC == other.positionWC;
  }
};

} // namespace shadow
