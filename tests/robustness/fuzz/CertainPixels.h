#pragma once

#include <vector>

#include "MaskTruth.h"
#include "PixelRays.h"
#include "RayCaster.h"

namespace shadow::fuzz
{

/// The truth of a scene, and which of its pixels have a right answer at all.
///
/// A pixel is certain when its answer stays the same
/// - at the four points 1/64 pixel off its centre diagonally, since rasterisers move corners that far;
/// - when the light moves by a few roundings: to the eight corners of a cube around it whose half side is 32
///   units in the last place, in double precision, of the largest coordinate of the scene and the light; or,
///   for a directional light, of 1.
class CertainPixels
{
public:
  CertainPixels(const truth::Scene& scene, const truth::View& view, const truth::Light& light);
  CertainPixels(const CertainPixels&) = delete;
  CertainPixels& operator=(const CertainPixels&) = delete;

  int getWidth() const { return this->truth.width(); }
  int getHeight() const { return this->truth.height(); }
  const std::vector<unsigned char>& getMask() const { return this->truth.mask(); }

  /// Casts up to twelve camera rays at the first question, then remembers.
  bool isCertain(int x, int y) const;

  /// Whether the light reaches what is just beyond the near plane, there and 1/64 pixel off. Elsewhere z-pass
  /// has no right answer.
  bool isLitAtNearPlane(int x, int y) const;

  /// Whether it does at a grid of points all over the near plane, and at the eye.
  bool isNearPlaneLit() const;

  /// @par Cost  O(pixels) camera rays
  std::size_t countCertain() const;

private:
  bool isLit(const truth::Ray& ray) const;
  bool isPointLit(const glm::dvec3& point) const;

  truth::RayCaster caster;
  truth::MaskTruth truth;
  truth::PixelRays rays;
  std::vector<truth::LocalTriangle> casters;
  truth::LocalLight light;
  std::vector<truth::LocalLight> movedLights;
  mutable std::vector<signed char> known; ///< a pixel's certainty; -1 not asked yet
};

} // namespace shadow::fuzz
