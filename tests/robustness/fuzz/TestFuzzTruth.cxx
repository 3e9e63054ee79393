// That what masks are held against is true where it is easy to get wrong: parallel views that are cut open,
// and lights nearer to a plane than single precision tells.
#include <cmath>

#include <gtest/gtest.h>

#include "FuzzSession.h"
#include "ShadowingRange.h"

namespace shadow::fuzz
{

namespace
{

FuzzMesh makeSquare(double half, double height)
{
  const glm::dvec3 a(-half, -half, height), b(half, -half, height), c(half, half, height),
      d(-half, half, height);
  FuzzMesh mesh;
  mesh.triangles = {{a, b, c}, {a, c, d}};
  return mesh;
}

/// A parallel view straight down on a floor at height 0 that fills it: 4 units high, 120 x 120 pixels, the
/// centre at the origin.
FuzzScene makeViewFromAbove()
{
  FuzzScene scene;
  scene.size = {120, 120};
  scene.meshes = {makeSquare(4.0, 0.0)};
  scene.camera.position = {0.0, 0.0, 3.0};
  scene.camera.parallelScale = 2.0;
  scene.camera.clippingRange = {0.5, 10.0};
  return scene;
}

/// Where the pixel's centre is on the floor.
glm::dvec2 getFloorPoint(int x, int y)
{
  return glm::dvec2(x + 0.5, y + 0.5) / 30.0 - 2.0;
}

/// Compares the true mask with a formula for whether a point of the floor is dark; pixels near its edge are
/// not certain and are left out.
template <class IsDark>
void expectTruth(const FuzzScene& scene, const IsDark& isDark)
{
  FuzzSession session;
  const DrawnScene drawn = session.draw(scene);
  int darkPixels = 0;
  int wrongPixels = 0;
  for (int y = 0; y < 120; ++y)
  {
    for (int x = 0; x < 120; ++x)
    {
      const bool dark = isDark(getFloorPoint(x, y));
      darkPixels += dark ? 1 : 0;
      const bool truth = drawn.truth->getMask()[static_cast<std::size_t>(y * 120 + x)] == 0;
      wrongPixels += truth != dark && drawn.truth->isCertain(x, y) ? 1 : 0;
    }
  }
  EXPECT_GT(darkPixels, 100);
  EXPECT_LT(darkPixels, 120 * 120 - 100);
  EXPECT_EQ(wrongPixels, 0);
}

} // namespace

TEST(FuzzTruth, ParallelSection_WhatIsCutAwayCastsAndIsNotSeen)
{
  FuzzScene scene = makeViewFromAbove();
  scene.meshes.push_back(makeSquare(0.5, 1.0));
  scene.light.positional = false;
  scene.light.position = glm::normalize(glm::dvec3(1.0, 0.5, 1.0));
  scene.camera.clippingRange = {2.5, 10.0}; // the near plane at height 0.5, under the square
  expectTruth(scene, [](const glm::dvec2& floor)
              { return std::abs(floor.x + 1.0) < 0.5 && std::abs(floor.y + 0.5) < 0.5; });
}

TEST(FuzzTruth, ParallelViewOfPointLight_SquareIsSeenAndCasts)
{
  FuzzScene scene = makeViewFromAbove();
  scene.meshes.push_back(makeSquare(0.5, 1.0));
  scene.light.position = {0.0, 0.0, 2.0};
  expectTruth(scene, [](const glm::dvec2& floor)
              { return std::abs(floor.x) < 1.0 && std::abs(floor.y) < 1.0 &&
                       !(std::abs(floor.x) < 0.5 && std::abs(floor.y) < 0.5); });
}

// The light is before the middle of a wall that reaches out of view to all sides.
TEST(FuzzTruth, LightWithinSinglePrecisionOfAWall_TheSideItIsOnIsLit)
{
  for (const double side : {1.0, -1.0})
  {
    FuzzScene scene = makeViewFromAbove();
    FuzzMesh wall;
    wall.triangles = {{glm::dvec3(-900, 0, -100), glm::dvec3(900, 0, -100), glm::dvec3(0, 0, 900)}};
    scene.meshes.push_back(wall);
    scene.light.position = {0.1, side * 1e-10, 2.0};
    expectTruth(scene, [side](const glm::dvec2& floor) { return floor.y * side < 0.0; });
  }
}

// A matrix in double precision moves the wall by less than single precision tells.
TEST(FuzzTruth, WallMovedByItsMatrix_IsWhereDoublePrecisionHasIt)
{
  for (const double side : {1.0, -1.0})
  {
    FuzzScene scene = makeViewFromAbove();
    FuzzMesh wall;
    wall.worldFromMC[3] = glm::dvec4(0.0, 1.0 + 1e-10 * side, 0.0, 1.0);
    const double y = 1.0 + 1e-10 * side;
    wall.triangles = {{glm::dvec3(-900, y, -100), glm::dvec3(900, y, -100), glm::dvec3(0, y, 900)}};
    scene.meshes.push_back(wall);
    scene.light.position = {0.1, 1.0, 2.0};
    expectTruth(scene, [side](const glm::dvec2& floor) { return (floor.y - 1.0) * side > 0.0; });
  }
}

// A triangle two units over the point, and a light above it: over its middle, beside it, at its edge, in its plane
// and below it.
TEST(ShadowingRange, LightOverBesideAndAtTheEdge)
{
  const truth::LocalTriangle triangle{glm::dvec3(-1, -1, 2), glm::dvec3(1, -1, 2), glm::dvec3(0, 1, 2), 0.0, 0, true,
                                      false, false};
  const auto find = [&](const glm::dvec3& point, const glm::dvec3& light, double halfSide)
  { return findShadowing(triangle, point, 0.0, glm::dvec4(light, 1.0), halfSide); };
  const glm::dvec3 below(0.0, -0.5, 0.0);
  EXPECT_EQ(find(below, {0.0, -0.5, 3.0}, 1e-9), Shadowing::Always);
  EXPECT_EQ(find(below, {0.0, -5.0, 3.0}, 1e-9), Shadowing::Never);
  EXPECT_EQ(find(below, {0.0, -0.5, 1.0}, 1e-9), Shadowing::Never) << "the light is on the point's side";
  EXPECT_EQ(find(below, {0.0, -0.5, 2.0}, 1e-9), Shadowing::Sometimes) << "the light is in the plane";
  // At the edge y = -1: what is seen past it depends on how far the light is off in which direction.
  for (const double y : {-3.0, -1.5, -1.0001})
  {
    EXPECT_EQ(find({0.0, y, 0.0}, {0.0, -1.0, 2.0}, 1e-9), Shadowing::Sometimes) << y;
    EXPECT_EQ(find({0.0, y, 0.0}, {0.0, -1.1, 2.0 + 1e-6}, 1e-9), Shadowing::Never) << y;
  }
  EXPECT_EQ(find({0.0, -3.0, 0.0}, {0.0, -0.9, 2.0 + 1e-6}, 1e-9), Shadowing::Always);
}

} // namespace shadow::fuzz
