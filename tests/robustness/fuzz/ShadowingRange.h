#pragma once

#include "TriangleTests.h"

namespace shadow::fuzz
{

/// From how many places of a cube around a light a triangle shadows a point.
enum class Shadowing
{
  Never,
  Sometimes,
  Always
};

/// Decides for all places of the cube, which samples do not: a light within rounding of an edge or a corner
/// sees next to it whatever lies in the direction from the edge in which the light happens to be off it.
///
/// On which side of a plane the light is, of the triangle's or of one through the point and an edge, is
/// linear in the light's place. Where rounding of the vertices could turn it, no side is certain either. A
/// point that is off the triangle's plane, but which that plane may turn past, as a sliver's may turn past
/// anything, may be on both of its sides.
///
/// @param point      caster's space
/// @param light      centre of the cube; a position (w = 1) or a direction towards it (w = 0)
/// @param halfSide   of the cube
/// @return Sometimes also where each of the sides is taken somewhere, and the triangle between them nowhere
Shadowing findShadowing(const truth::LocalTriangle& triangle, const glm::dvec3& point, double pointRounding,
                        const glm::dvec4& light, double halfSide);

} // namespace shadow::fuzz
