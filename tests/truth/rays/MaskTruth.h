#pragma once

#include <mutex>
#include <vector>

#include "PixelRays.h"
#include "RayCaster.h"

namespace shadow::truth
{

/// The true shadow mask of one light: 255 where the light reaches the pixel's centre and on the background, 0
/// in shadow. Row 0 is the lowest, as OpenGL reads pixels; pixel (x, y) is at y * width + x.
class MaskTruth
{
public:
  /// How far off the centre, along x and along y, the four further rays of a certain pixel run, in pixels.
  static constexpr double certainOffset = 1.0 / 64.0;

  /// Casts one camera ray a pixel, on all cores.
  /// @param caster  has to outlive this object
  MaskTruth(const RayCaster& caster, const View& view, const Light& light);

  int width() const { return this->size.x; }
  int height() const { return this->size.y; }
  const std::vector<unsigned char>& mask() const { return this->values; }

  /// Whether the four points diagonally off the centre have the mask value of the centre. A rasteriser may
  /// see any of them, so other pixels have no right value. Casts up to four camera rays.
  bool isCertain(int x, int y) const;

  /// isCertain() of every pixel as 1 or 0, in mask order; computed on all cores at the first call, then kept.
  const std::vector<unsigned char>& certainPixels() const;

  /// Share of certain pixels, 0 to 1; 1 for an empty view.
  double certainShare() const;

private:
  unsigned char valueAt(double x, double y) const;

  const RayCaster& caster;
  PixelRays rays;
  LocalLight light;
  glm::ivec2 size;
  std::vector<unsigned char> values;
  mutable std::once_flag certainOnce;
  mutable std::vector<unsigned char> certain;
};

} // namespace shadow::truth
