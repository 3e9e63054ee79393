#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "Light.h"

namespace shadow
{

/// A point or vector as the sum of two floats a coordinate: 48 bits of it, for a GL without doubles.
struct SplitVector
{
  glm::vec3 high{0.0f}; ///< rounded to float
  glm::vec3 low{0.0f};  ///< what the rounding lost, rounded to float
};

/// @par Error  2^-49 of each coordinate, or the smallest float
SplitVector split(const glm::dvec3& value);

/// Scene space, the one coordinate system in which the GPU methods see all vertices and lights:
/// scene = (world - originWC) / unit.
///
/// The unit is a power of two, so that dividing by it rounds nothing, and about as large as the scene:
/// coordinates are then near 1, and products of several of them stay within the range of floats.
struct SceneFrame
{
  glm::dvec3 originWC{0.0};
  double unit = 1.0;

  /// A frame for what lies in a box. @post coordinates in it are at most 1
  static SceneFrame around(const glm::dvec3& lowerWC, const glm::dvec3& upperWC);

  /// Whether a frame made for another box will do: coordinates in this one are at most 2 and reach beyond
  /// 1/8.
  bool suits(const glm::dvec3& lowerWC, const glm::dvec3& upperWC) const;

  bool operator==(const SceneFrame& other) const
  {
    return this->originWC == other.originWC && this->unit == other.unit;
  }

private:
  double reachOf(const glm::dvec3& lowerWC, const glm::dvec3& upperWC) const;
};

/// A light in scene space. What faces it depends on (position.high + position.low, w) up to a positive
/// factor: a light far away has a small w, a directional one 0.
struct SceneLight
{
  SplitVector position; ///< coordinates at most 1
  float w = 0.0f;       ///< a power of two at most 1, or 0
};

/// A light as scene space sees it. Nothing when it is not finite.
std::optional<SceneLight> lightToScene(const Light& light, const SceneFrame& frame);

} // namespace shadow
