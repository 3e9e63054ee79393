#pragma once

#include <glm/glm.hpp>

#include "PixelRays.h"
#include "RayCaster.h"

namespace shadow::fuzz
{

/// How large the numbers are that the depth of a triangle in a pixel is made of, as a distance from the eye:
/// that depth has the digits of single precision, of this distance. It is the largest of
/// - the distance to the near plane, and the sum of the eye's and a corner's largest coordinates, as a
///   position in clip space is a sum with both in it;
/// - in a parallel view half the distance between the near and the far plane, in which depth in clip space
///   changes by 1: it is a sum with such numbers in it, and no perspective gives digits back near the far end;
/// - the depth of the triangle's plane at the corners of the window, as a rasteriser has the plane's equation
///   on the screen and adds up its terms;
/// - the difference in depth across the part of the triangle that is in the view, times how many times as
///   long as it is high the triangle is that is drawn in the pixel. That part is drawn as several triangles
///   with corners where the view cuts it; which ones is the rasteriser's choice, so it is the thinnest.
///
/// @param rays      in the space of the triangle
/// @param size      of the window, pixels
/// @param at        the point of the window through which @p ray goes, pixels
/// @param hit       where it meets the triangle
double getDepthReach(const truth::PixelRays& rays, const glm::dvec2& size, const glm::dvec2& at,
                     const truth::Ray& ray, const truth::LocalTriangle& triangle, const truth::Hit& hit);

} // namespace shadow::fuzz
