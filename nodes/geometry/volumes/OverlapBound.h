#pragma once

#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

#include "SEDGeometry.h"

namespace shadow
{

struct SilhouetteEdge;
struct LightFacing;
enum class Casting;

/// Number of triangles that cast.
std::size_t countCasting(const LightFacing& facing, Casting casting);

/// Upper bound of how often one ray from the light enters the caster's shadow volume.
///
/// An 8-bit stencil buffer counts modulo 256, so volumes whose bounds add up to more than 255 must not share
/// one count. Walking from a ray that is known not to hit (or whose hits are counted exactly) to any other
/// ray, the count changes only where silhouette edges are crossed; the bound is the largest number of edges
/// that any such walk can cross. It is never below the truth, and rarely more than twice it. Rays that pass a
/// vertex within rounding (about 1e-12 of a turn) are left out: single precision cannot place them on either
/// side.
///
/// @param lightMC  relative to the geometry's origin; w = 0: direction towards the light
/// @par Cost    O(s log s) for s silhouette edges; O(triangles) more when a point light lies inside the
/// bounding
///              sphere
std::size_t boundOverlap(const SEDGeometry& geometry, const std::vector<SilhouetteEdge>& silhouette,
                         const LightFacing& facing, Casting casting, const glm::dvec4& lightMC);

} // namespace shadow
