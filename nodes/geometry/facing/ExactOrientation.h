#pragma once

#include <glm/glm.hpp>

namespace shadow
{

/// On which side of the plane through three points is a light? Exactly, without rounding.
///
/// @param a,b,c    corners, any finite float32 values
/// @param lightMC  w = 1: position; w = 0: direction towards the light; finite, in the coordinates of the
/// corners
/// @return  the sign of dot(cross(b - a, c - a), lightMC.xyz - lightMC.w * a): 1 when the light sees a, b, c
///          counter-clockwise, -1 when clockwise, 0 when it lies in their plane or they have none
/// @pre   the light's coordinates are zero or of magnitude 1e-150 to 1e150, so that no product underflows
/// @par Cost    some hundred operations for ordinary coordinates, a few microseconds at worst
/// @par Source  Shewchuk 1997, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
///              Predicates"
int exactOrientation(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::dvec4& lightMC);

/// The same sign, decided in double precision where rounding cannot change it, exactly elsewhere.
///
/// @pre   as exactOrientation()
/// @par Cost  some fifty operations but for lights within rounding of the plane
int orientation(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::dvec4& lightMC);

/// The cross product of the rays from a light's position to two points, each coordinate exact but for a
/// rounding or two: where the light is within rounding of the line through them, its direction is that of the
/// light beside the line all the same, and agrees with exactOrientation() of triangles at that edge.
///
/// @param a,b      any finite float32 values
/// @param lightMC  a position, in the coordinates of the points; coordinates as exactOrientation() wants them
/// @return  0 where the light is on the line: no triangle with that edge faces it, or looks away, then
/// @par Cost  a microsecond
glm::dvec3 exactCross(const glm::vec3& a, const glm::vec3& b, const glm::dvec3& lightMC);

} // namespace shadow
