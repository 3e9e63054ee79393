#pragma once

#include <vector>

#include "MaskTruth.h"
#include "PixelRays.h"
#include "RayCaster.h"
#include "SeenOutlines.h"

namespace shadow::fuzz
{

/// The truth of a scene, and which of its pixels have a right answer at all.
///
/// A pixel is certain when its answer stays the same
/// - at the four points 1/64 pixel off its centre diagonally, since rasterisers move corners that far, where
///   the rest holds as well; background, which has no answer, is seen at all or at none of the five;
/// - when within 1/256 pixel no triangle ends that is seen, and no volume passes that is thinner than that,
///   see SeenOutlines.h;
/// - when what is seen moves in depth by 4 units in the last place, in single precision, of the largest
///   numbers that depth is made of, see DepthReach.h: where light grazes a surface, its volumes are as good
///   as in it. No edge may be passed by that, neither the triangle's own nor of one that coincides with it;
/// - when the light moves by a few roundings: anywhere in a cube around it whose half side is 32 units in the
///   last place, in double precision, of the largest coordinate of the scene and the light; or, for a
///   directional light, of 1. What blocks the light is decided for all of the cube, see ShadowingRange.h,
///   what else counts, as the cone of a spot light, for its corners;
/// - and when the light lies in the plane of no triangle that counts here, as far as rounding of its corners
///   tells: not of the one that is seen, nor of one between it and the light, unless another triangle blocks
///   the light wherever it is moved. The ray caster takes these for neither side, see truth::sideOfPlane().
///   Slivers turn about their long side with the least rounding, so for them this reaches farther than the
///   cube. Points in double precision are drawn in single precision, by VTK as well, so there it is that
///   rounding;
/// - and when the light does not graze the surface that is seen, by less than 1e-6: which pixels are seen of
///   a surface is known to single precision only, and so is which of two surfaces as flat as that lies in
///   front.
class CertainPixels
{
public:
  /// @param doublePoints  the points of the scene's meshes do not fit into single precision
  CertainPixels(const truth::Scene& scene, const truth::View& view, const truth::Light& light,
                bool doublePoints = false);
  CertainPixels(const CertainPixels&) = delete;
  CertainPixels& operator=(const CertainPixels&) = delete;

  int getWidth() const { return this->truth.width(); }
  int getHeight() const { return this->truth.height(); }
  const std::vector<unsigned char>& getMask() const { return this->truth.mask(); }

  /// Casts up to a hundred rays at the first question, then remembers.
  bool isCertain(int x, int y) const;

  /// @par Cost  O(pixels) camera rays
  std::size_t countCertain() const;

private:
  bool findCertainty(int x, int y) const;
  bool hasSameAnswerNearby(const truth::Hit& hit, bool isShadowed) const;
  bool hasSameBlockersNearby(const truth::Hit& hit) const;
  bool hasSameAnswerInDepth(const glm::dvec2& at, const truth::Ray& ray, const truth::Hit& hit,
                            bool isShadowed) const;
  bool leavesCoincident(const truth::Hit& hit, const glm::dvec3& moved, double lifted) const;
  bool isLightInOwnPlane(const truth::Hit& hit) const;
  bool isLightInPlaneOfBlocker(const truth::Hit& hit) const;

  truth::RayCaster caster;
  truth::MaskTruth truth;
  truth::PixelRays rays;
  std::vector<truth::LocalTriangle> triangles; ///< in the scene's order
  double halfSide;                            ///< of the cube below
  std::vector<truth::LocalLight> movedLights; ///< the light itself, too
  SeenOutlines outlines;
  mutable std::vector<signed char> known; ///< a pixel's certainty; -1 not asked yet
};

} // namespace shadow::fuzz
