// Which faces may be large on the screen: the scale of a view, and the list that is kept for it.

#include <limits>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "LargeFaces.h"
#include "TestMeshes.h"

using namespace shadow;
using namespace shadow::test;

namespace
{

constexpr int width = 400;
constexpr int height = 300;

/// Looks along -z from a height over the middle.
glm::dmat4 lookFrom(double z, bool parallel = false)
{
  const double aspect = static_cast<double>(width) / height;
  const glm::dmat4 clip = parallel ? glm::ortho(-2.0 * aspect, 2.0 * aspect, -2.0, 2.0, 0.1, 100.0)
                                   : glm::perspective(glm::radians(60.0), aspect, 0.1, 100.0);
  return clip *
         glm::lookAt(glm::dvec3(0.0, 0.0, z), glm::dvec3(0.0, 0.0, z - 1.0), glm::dvec3(0.0, 1.0, 0.0));
}

/// Pixels of a unit across the view at a depth: its ends, as they are projected.
double project(const glm::dmat4& clipFromMC, double z)
{
  const glm::dvec4 from = clipFromMC * glm::dvec4(0.0, 0.0, z, 1.0);
  const glm::dvec4 to = clipFromMC * glm::dvec4(0.0, 1.0, z, 1.0);
  return 0.5 * height * (to.y / to.w - from.y / from.w);
}

/// The listed faces for a scale.
std::size_t countFound(LargeFaces& large, const SEDGeometry& geometry, double pixels, double lineReach = 1.5)
{
  large.find(geometry, ContributingFaces(geometry, TopologyAwareMesh(geometry)), pixels, lineReach);
  return countFaces(large.getRuns());
}

} // namespace

TEST(LargeFaces, MeasurePixels_IsTheProjectionOfAUnitInTheMiddle)
{
  const SEDGeometry cube = build(makeCube({0.0, 0.0, 0.0}, 2.0));
  for (const double z : {2.0, 5.0, 40.0})
  {
    EXPECT_NEAR(measurePixels(cube, lookFrom(z), width, height), project(lookFrom(z), 0.0), 1e-9) << z;
    EXPECT_NEAR(measurePixels(cube, lookFrom(z, true), width, height), 300.0 / 4.0, 1e-9) << z;
    EXPECT_NEAR(measurePixels(cube, glm::scale(lookFrom(z), glm::dvec3(3.0)), width, height),
                3.0 * project(lookFrom(z), 0.0), 1e-9)
        << z;
  }
}

TEST(LargeFaces, MeasurePixels_EyeInTheMesh_AQuarterOfItsHalfDepthAway)
{
  const SEDGeometry cube = build(makeCube({0.0, 0.0, 0.0}, 2.0));
  const double nearest = project(lookFrom(0.25), 0.0);
  for (const double z : {0.25, 0.1, 0.0, -0.9})
  {
    EXPECT_NEAR(measurePixels(cube, lookFrom(z), width, height), nearest, 1e-9) << z;
  }
}

TEST(LargeFaces, MeasurePixels_MeshBehindTheEye_Zero)
{
  const SEDGeometry cube = build(makeCube({0.0, 0.0, 0.0}, 2.0));
  EXPECT_EQ(measurePixels(cube, lookFrom(-1.5), width, height), 0.0);
  TriangleSoup flat;
  flat.points = {{-1.0, -1.0, 0.0}, {1.0, -1.0, 0.0}, {0.0, 1.0, 0.0}};
  flat.triangles = {{0, 1, 2}};
  EXPECT_EQ(measurePixels(build(flat), lookFrom(-1.0), width, height), 0.0);
  LargeFaces large;
  EXPECT_EQ(countFound(large, cube, 0.0), 0u);
  EXPECT_EQ(countFound(large, cube, std::numeric_limits<double>::infinity()), 12u) << "eye in a flat mesh";
}

TEST(LargeFaces, List_HoldsEveryFaceFromTheWantedLengthOn)
{
  // Edges of 2 and of 2.83.
  const SEDGeometry cube = build(makeCube({0.0, 0.0, 0.0}, 2.0));
  for (const double reach : {1.0, 4.5, 16.5})
  {
    const double shortest = std::max(128.0, 32.0 * (reach + 1.4142136));
    for (double pixels = 1.0; pixels < 4000.0; pixels *= 1.07)
    {
      LargeFaces large;
      const std::size_t found = countFound(large, cube, pixels, reach);
      EXPECT_TRUE(2.83 * pixels < shortest || found == 12) << pixels;
      EXPECT_TRUE(2.83 * pixels > 0.7 * shortest || found == 0) << pixels;
      EXPECT_LE(large.getLength(), shortest / pixels) << "what the shader asks is listed";
    }
  }
}

TEST(LargeFaces, List_KeptWhileTheScaleIsMuchTheSame)
{
  const SEDGeometry cube = build(makeCube({0.0, 0.0, 0.0}, 2.0));
  // To and fro about every scale: one list.
  for (double pixels = 1.0; pixels < 1000.0; pixels *= 1.03)
  {
    LargeFaces large;
    countFound(large, cube, pixels);
    const float length = large.getLength();
    for (const double change : {1.001, 0.999, 1.3, 0.8, 1.4, 0.72})
    {
      countFound(large, cube, change * pixels);
      EXPECT_EQ(large.getLength(), length) << pixels << " by " << change;
    }
    countFound(large, cube, 1.5 * pixels);
    EXPECT_LT(large.getLength(), length) << pixels;
    countFound(large, cube, 0.6 * pixels);
    EXPECT_GT(large.getLength(), length) << pixels;
  }
}

TEST(LargeFaces, Cleared_NoFaceIsLong)
{
  const SEDGeometry cube = build(makeCube({0.0, 0.0, 0.0}, 2.0));
  LargeFaces large;
  EXPECT_EQ(large.getLength(), std::numeric_limits<float>::max());
  EXPECT_EQ(countFound(large, cube, 1000.0), 12u);
  large.clear();
  EXPECT_EQ(large.getLength(), std::numeric_limits<float>::max());
  EXPECT_TRUE(large.getRuns().empty());
}
