#pragma once

#include <cstdint>

#include <glm/glm.hpp>

#include "Light.h"
#include "SEDGeometry.h"
#include "SceneFrame.h"
#include "ShadowVolume.h"

namespace shadow
{

/// Of which triangles shaders/facing.glsl may get the facing wrong: those in whose plane the light is, but
/// for the rounding of 48 bits. For a GL that has exact arithmetic there.
///
/// Two kinds of rounding. Corners and light are rounded as they get to the GPU, if they are not exact there;
/// and each step rounds relative to its result.
class GPUFacingBound
{
public:
  GPUFacingBound() = default;

  /// Where corners are scaled only, which rounds nothing: see GeometryTexels::getFrame().
  static GPUFacingBound inModel(const SEDGeometry& geometry, const glm::dvec4& lightMC);

  /// Where corners and lights are transformed into the frame of a VETCollection, in double precision.
  ///
  /// @param lightMC  that light, as lightToModel() gives it, with what that rounds
  /// @pre   isInvertible(modelToWorld)
  static GPUFacingBound inScene(const SEDGeometry& geometry, const glm::dmat4& modelToWorld,
                                const SceneFrame& frame, const Light& light, const glm::dvec4& lightMC);

  /// Every triangle of which the GPU is not sure is as close to the light as FacingDecider::widenDoubt() has
  /// it, or has a plane of zeros.
  /// @param w  of the light
  double getMargin(const SEDGeometry& geometry, double w) const;

  /// A triangle without area counts as sure: whichever side it is said to face, all that it would add has no
  /// volume.
  bool isSure(const SEDGeometry& geometry, std::uint32_t triangle, const glm::dvec4& lightMC) const;

  bool operator==(const GPUFacingBound& other) const
  {
    return this->linear == other.linear && this->corner == other.corner && this->light == other.light;
  }

private:
  glm::dmat3 linear{1.0}; ///< from model space to the one in which the GPU decides
  double corner = 0.0;    ///< how far off a corner may be there, each coordinate
  double light = 0.0;     ///< the same for the light, relative to the corners
};

/// As computeFacing() without a bound, on the way of the ClusterTree.
///
/// @return  whether the GPU surely finds the same, but for triangles without area
/// @par Cost  as of FacingDecider::compareClusters()
bool computeFacing(const SEDGeometry& geometry, const glm::dvec4& lightMC, const GPUFacingBound& bound,
                   LightFacing& facing);

} // namespace shadow
