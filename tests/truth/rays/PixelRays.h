#pragma once

#include "TruthScene.h"

namespace shadow::truth
{

/// Camera rays of a view: perspective, off-centre, parallel or sheared.
///
/// A ray is the line in which two planes meet, x = u w and y = v w, so that its direction comes straight from
/// the matrix and no inverse is taken: the two ends of a narrow or far-away frustum never cancel.
class PixelRays
{
public:
  /// @param originWC  where the rays' space has its origin, see RayCaster::originWC()
  PixelRays(const View& view, const glm::dvec3& originWC);

  /// The ray through a point of the window, in pixels from its lower left corner: the centre of the pixel in
  /// column i and row j (row 0 is the lowest) is (i + 0.5, j + 0.5).
  Ray through(double x, double y) const;

  /// A point of the rays' space in clip space, but for z: there its height over the near plane, 0 on it and
  /// rising inwards as z + w does.
  glm::dvec4 toClip(const glm::dvec3& point) const;

  /// The point of the window, in pixels, that a clip space position with w > 0 falls on.
  glm::dvec2 toPixels(const glm::dvec4& clip) const;

  /// Where a ray of this view has a given height over the near plane.
  glm::dvec3 atHeight(const Ray& ray, double height) const;

  /// Where all rays come from: a position (w = 1) or, of a parallel view, the direction towards it (w = 0).
  glm::dvec4 eye() const;

private:
  glm::dvec4 rowX, rowY, rowW, nearPlane;
  glm::dvec2 ndcPerPixel;
};

} // namespace shadow::truth
