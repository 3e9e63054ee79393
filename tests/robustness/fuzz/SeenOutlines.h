#pragma once

#include <optional>
#include <vector>

#include "PixelRays.h"
#include "RayCaster.h"

namespace shadow::fuzz
{

/// The outlines of triangles on the screen, where a rasteriser may draw a triangle beside itself.
///
/// Corners are rounded to the rasteriser's grid of 1/256 pixel, and before that to single precision. So a
/// triangle may be drawn in a pixel whose centre is off it by less than that: with the depth that its plane
/// has beyond its edge, where the side of its volume that hangs there is in front; and where it is thinner,
/// turned over.
class SeenOutlines
{
public:
  /// @param all    kept by reference, as @p view is; in the space of its rays
  /// @param light  in the same space
  SeenOutlines(const std::vector<truth::LocalTriangle>& all, const truth::PixelRays& view,
               const glm::dvec4& light);

  /// Whether such an outline passes a point of the window, in pixels. Does not count what is hidden, nor an
  /// edge across which one other triangle goes on: on the other side of it for the eye and for the light.
  ///
  /// @param hit  what is seen at the point
  /// @par Cost   O(triangles), O(triangles) more for each edge that passes the point
  bool pass(const glm::dvec2& at, const std::optional<truth::Hit>& hit) const;

  /// Whether the shadow volume of a triangle passes that is thinner than the grid there, or that ends there,
  /// at infinity, in a line as thin. Its faces are then as thin, and are drawn here and there, without a
  /// depth.
  /// @par Cost  O(triangles)
  bool passThinVolume(const glm::dvec2& at) const;

private:
  struct Side;

  std::vector<Side> getSeenSides(const truth::LocalTriangle& triangle) const;
  bool isNear(const Side& side, const glm::dvec2& at, double hiddenBehind) const;
  glm::dvec4 getRay(const glm::dvec3& point) const;
  bool isNearLine(const glm::dvec4& from, const glm::dvec4& to, const glm::dvec2& at) const;
  double getRounding(const glm::dvec3& point) const;
  bool goesOn(const truth::LocalTriangle& triangle, std::size_t side) const;

  const std::vector<truth::LocalTriangle>& triangles;
  const truth::PixelRays& rays;
  glm::dvec4 lightPosition;
};

} // namespace shadow::fuzz
