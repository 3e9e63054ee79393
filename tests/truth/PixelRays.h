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

private:
  glm::dvec4 rowX, rowY, rowW, nearPlane;
  glm::dvec2 ndcPerPixel;
};

} // namespace shadow::truth
