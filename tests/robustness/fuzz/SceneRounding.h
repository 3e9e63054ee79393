#pragma once

#include <algorithm>

#include "TriangleTests.h"
#include "TruthScene.h"

namespace shadow::fuzz
{

/// Of roundings, those of single over those of double precision.
inline constexpr double fromDoubleToSingle = 0x1p29;

/// In magnitude, of the points and of the light.
/// @param lightPosition  a direction counts with its coordinates, too
inline double getLargestCoordinate(const truth::Scene& scene, const glm::dvec4& lightPosition)
{
  double largest = truth::largestCoordinate(glm::dvec3(lightPosition));
  for (const truth::Triangle& triangle : scene.triangles)
  {
    for (const glm::dvec3& corner : {triangle.a, triangle.b, triangle.c})
    {
      largest = std::max(largest, truth::largestCoordinate(corner));
    }
  }
  return largest;
}

} // namespace shadow::fuzz
