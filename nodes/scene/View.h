#pragma once

#include <array>

#include <glm/glm.hpp>

namespace shadow
{

/// Everything about the camera and its window that the shadow stages need.
struct View
{
  /// World to clip space as VTK draws, depth in -1..1; column vectors.
  glm::dmat4 clipFromWC{1.0};
  int width = 0;  ///< pixels
  int height = 0; ///< pixels
  bool parallel = false;
  bool mirrored = false;            ///< counter-clockwise in the world is clockwise on the screen
  std::array<glm::dvec3, 4> nearWC; ///< corners of the near rectangle, in cyclic order
  std::array<glm::dvec4, 5>
      planes;                ///< left, right, bottom, top, near: dot(plane, p) >= 0 inside, world space
  double nearW = 0.0;        ///< perspective: clip w on the near plane; parallel: unused
  glm::dvec4 viewDepth{0.0}; ///< dot(viewDepth, p): distance in front of the near plane, world space
};

/// Derives a view from VTK's world-to-clip matrix. @pre the matrix can be inverted
View makeView(const glm::dmat4& clipFromWC, int width, int height);

/// How depth is stored in the stencil target.
struct DepthRange
{
  bool reversed = true; ///< 1 near, 0 far, clip space 0..1; else 0 near, 1 far, clip space -1..1
  double nearest = 0.0; ///< parallel only: distances from the near plane between which depth is linear
  double farthest = 1.0;
};

/// The view's clip matrix with the depth row of the shadow stages: far plane at infinity for a perspective,
/// linear between DepthRange::nearest and farthest for a parallel view.
///
/// @par Source  Everitt & Kilgard 2002 (far plane at infinity); Lapidous & Jiao 1999 (reversed depth)
glm::dmat4 shadowClipFromWC(const View& view, const DepthRange& range);

/// VTK's window depth, 0 near and 1 far, as x + y times the depth that is stored with shadowClipFromWC().
glm::dvec2 windowFromDepth(const View& view, const DepthRange& range);

} // namespace shadow
