#include "TestLights.h"

#include "TestMeshes.h"
#include "VolumeOracle.h"

namespace shadow::test
{

namespace
{

glm::dvec3 makePlace(const SEDGeometry& geometry, std::mt19937& random, int kind)
{
  const glm::dvec3 centre = 0.5 * (geometry.getLowerBound() + geometry.getUpperBound());
  const glm::dvec3 half = 0.5 * (geometry.getUpperBound() - geometry.getLowerBound());
  const double size = glm::length(half);
  const auto [a, b, c] = getCorners(geometry, random() % geometry.getTriangles().size());
  const glm::dvec3 somewhere = randomPoint(random, 1.0);
  switch (kind)
  {
  case 0:
    return centre + 2.0 * size * somewhere;
  case 1:
    return centre + (random() & 1u ? 1e3 : 1e6) * size * somewhere;
  case 4:
    return centre + half * somewhere;
  case 5:
    return a;
  case 6:
    return a * (1.0 + 1e-12);
  case 7:
    return 0.5 * (a + b);
  case 8:
    // Small integers, so that the point is hardly rounded off the plane.
    return a + static_cast<double>(random() % 9) * (b - a) - static_cast<double>(random() % 9) * (c - a);
  case 9:
    return a + 3.0 * somewhere.x * (b - a) + 3.0 * somewhere.y * (c - a);
  default:
    return a + 1e-2 * size * somewhere;
  }
}

glm::dvec3 makeDirection(const SEDGeometry& geometry, std::mt19937& random, int kind)
{
  const auto [a, b, c] = getCorners(geometry, random() % geometry.getTriangles().size());
  if (kind == 3)
  {
    glm::dvec3 axis(0.0);
    axis[static_cast<int>(random() % 3)] = random() & 1u ? 1.0 : -1.0;
    return axis;
  }
  const glm::dvec3 somewhere = randomPoint(random, 1.0);
  if (kind == 2)
  {
    return somewhere;
  }
  return random() & 1u ? b - a : (b - a) + somewhere.x * (c - a);
}

} // namespace

glm::dvec4 makeLight(const SEDGeometry& geometry, std::mt19937& random, int kind)
{
  kind %= lightKinds;
  if (kind == 2 || kind == 3 || kind == 11)
  {
    return {makeDirection(geometry, random, kind), 0.0};
  }
  return {makePlace(geometry, random, kind), 1.0};
}

std::vector<glm::dvec4> makeLights(const SEDGeometry& geometry, std::size_t count, std::uint32_t seed)
{
  std::mt19937 random(seed);
  std::vector<glm::dvec4> lights;
  for (std::size_t index = 0; index < count; ++index)
  {
    lights.push_back(makeLight(geometry, random, static_cast<int>(index % lightKinds)));
  }
  return lights;
}

} // namespace shadow::test
