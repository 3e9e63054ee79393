#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "SEDGeometry.h"
#include "ShadowVolume.h"
#include "SilhouetteFinder.h"

namespace shadow
{

/// A caster's shadow volume for one light, in as many volumes as it takes for none to be entered by one ray
/// more often than options.countable: nearly always one. Their counts can be looked at one after the other,
/// as an 8-bit stencil needs.
///
/// Where it takes more, the triangles are divided in halves, each with a silhouette of its own.
///
/// @param exactFacing  of computeFacing(); the finder may simplify it
/// @param lightMC  relative to the geometry's origin; w = 0: direction towards the light
/// @par Cost  O(triangles) for the silhouette; each division adds as much
std::vector<ShadowVolume> makeCountableVolumes(const SEDGeometry& geometry, const SilhouetteFinder& finder,
                                               const LightFacing& exactFacing, const glm::dvec4& lightMC,
                                               const ShadowVolumeOptions& options);

} // namespace shadow
