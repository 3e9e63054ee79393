#pragma once

#include <cmath>
#include <functional>

#include <glm/glm.hpp>

#include "TestMeshes.h"

namespace shadow::test
{

/// Where a point goes.
using Move = std::function<glm::dvec3(const glm::dvec3&)>;

inline TriangleSoup moved(TriangleSoup soup, const Move& move)
{
  for (glm::dvec3& point : soup.points)
  {
    point = move(point);
  }
  return soup;
}

/// No coordinate changes its order.
inline glm::dvec3 stretch(const glm::dvec3& point)
{
  return point * glm::dvec3(1.5, 1.25, 1.125);
}

inline glm::dvec3 turn(const glm::dvec3& point)
{
  return {-point.y, point.x, point.z};
}

inline Move bulge(double height)
{
  return [height](const glm::dvec3& point)
  { return point * (1.0 + height * std::sin(7.0 * point.x) * std::cos(5.0 * point.y)); };
}

inline TriangleSoup makeTestTorus()
{
  return makeTorus(0.4, 0.15, 40, 20);
}

} // namespace shadow::test
