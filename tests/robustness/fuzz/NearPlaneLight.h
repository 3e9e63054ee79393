#pragma once

#include "PixelRays.h"
#include "TruthScene.h"

namespace shadow::fuzz
{

/// Whether no shadow meets the part of the near plane that is seen: no triangle, not even in part, lies
/// between it and the light. Only then is z-pass sure to be right.
///
/// @param rays  of the view, around the world's origin
/// @param size  of the view, pixels
/// @param doublePoints  the points do not fit into single precision, in which they are drawn
/// @return false, too, for a light in the near plane, where nothing is sure
/// @par Cost  O(triangles)
bool isNearPlaneLit(const truth::Scene& scene, const truth::PixelRays& rays, const glm::dvec2& size,
                    const truth::Light& light, bool doublePoints);

} // namespace shadow::fuzz
