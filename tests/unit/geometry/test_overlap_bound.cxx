// boundOverlap() is never below what counting along rays finds, and not far above it.

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "OverlapBound.h"
#include "SilhouetteFinder.h"
#include "TestMeshes.h"
#include "VolumeOracle.h"

namespace shadow::test
{

namespace
{

std::size_t boundOf(const SEDGeometry& geometry, const glm::dvec4& light, Casting casting)
{
  const LightFacing facing = computeFacing(geometry, light);
  const auto silhouette = makeSilhouetteFinder(SilhouetteMethod::BruteForce)->find(geometry, facing, casting);
  return boundOverlap(geometry, silhouette, facing, casting, light);
}

/// The largest count found along rays through @p samples random places on triangles.
std::size_t searchMost(const SEDGeometry& geometry, const glm::dvec4& light, Casting casting, int samples,
                       std::mt19937& random)
{
  const LightFacing facing = computeFacing(geometry, light);
  std::uniform_real_distribution<double> weight(0.0, 1.0);
  std::size_t most = 0;
  for (int sample = 0; sample < samples; ++sample)
  {
    const auto corners = getCorners(geometry, random() % geometry.getTriangles().size());
    const double u = weight(random);
    const double v = (1.0 - u) * weight(random);
    const glm::dvec3 on = corners[0] + u * (corners[1] - corners[0]) + v * (corners[2] - corners[0]);
    const glm::dvec3 away = light.w == 0.0 ? -glm::normalize(glm::dvec3(light)) : on - glm::dvec3(light);
    const glm::dvec3 end = on + 500.0 * away;
    const glm::dvec4 from = light.w == 0.0 ? glm::dvec4(end - 1000.0 * away, 1.0) : light;
    const LightFacing* only = casting == Casting::LightFacing ? &facing : nullptr;
    most = std::max(most, countBlockers(geometry, end, from, only));
  }
  return most;
}

} // namespace

TEST(OverlapBound, AnyMesh_NeverBelowTrueCount)
{
  std::mt19937 random(1);
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    for (int round = 0; round < 24; ++round)
    {
      const double reach = round % 4 < 2 ? 1.0 : 10.0;
      const glm::dvec4 light(randomPoint(random, reach), round % 2);
      for (const Casting casting : {chooseCasting(geometry, light), Casting::EveryTriangle})
      {
        EXPECT_GE(boundOf(geometry, light, casting), searchMost(geometry, light, casting, 100, random));
      }
    }
  }
}

TEST(OverlapBound, RandomSoups_NeverBelowTrueCountAndNotFarAbove)
{
  std::mt19937 random(2);
  for (std::uint32_t seed = 0; seed < 12; ++seed)
  {
    const SEDGeometry geometry = build(makeRandomSoup(400, seed));
    const double reach = seed % 3 == 0 ? 0.5 : 5.0;
    const glm::dvec4 light(reach * glm::normalize(randomPoint(random, 1.0)), seed % 2);
    const std::size_t bound = boundOf(geometry, light, Casting::EveryTriangle);
    const std::size_t found = searchMost(geometry, light, Casting::EveryTriangle, 400, random);
    EXPECT_GE(bound, found);
    EXPECT_LE(bound, 4 * found);
  }
}

TEST(OverlapBound, StackedPlates_CountsThemAll)
{
  const SEDGeometry geometry = build(makePlates(300));
  for (glm::dvec4 light : {glm::dvec4(0.1, 0.2, 1000, 1), glm::dvec4(0.1, 0.2, 301, 1),
                           glm::dvec4(0, 0, 1, 0), glm::dvec4(1e-4, 3e-4, 1, 0)})
  {
    light -= light.w * glm::dvec4(geometry.getOrigin(), 0.0);
    const std::size_t bound = boundOf(geometry, light, Casting::EveryTriangle);
    EXPECT_GE(bound, 300u);
    EXPECT_LE(bound, 600u);
    const LightFacing facing = computeFacing(geometry, light);
    const auto silhouette =
        makeSilhouetteFinder(SilhouetteMethod::BruteForce)->find(geometry, facing, Casting::EveryTriangle);
    const ShadowVolume volume =
        extrudeSilhouette(geometry, silhouette, facing, Casting::EveryTriangle, light, ShadowVolumeOptions());
    EXPECT_EQ(volume.overlapBound, bound);
  }
  // Amidst the plates, each ray meets those on one side only.
  std::mt19937 random(3);
  const glm::dvec4 amidst(0.1, 0.2, 0.25, 1);
  EXPECT_GE(boundOf(geometry, amidst, Casting::EveryTriangle),
            searchMost(geometry, amidst, Casting::EveryTriangle, 300, random));
  // Seen edge on, hardly any two stand behind each other.
  EXPECT_LE(boundOf(geometry, glm::dvec4(1000, 0.2, 0.3, 1), Casting::EveryTriangle), 64u);
}

TEST(OverlapBound, FineTorus_StaysSmall)
{
  std::mt19937 random(4);
  const SEDGeometry geometry = build(makeTorus(1.0, 0.4, 240, 120));
  for (int round = 0; round < 60; ++round)
  {
    const double reach = round % 3 == 0 ? 0.3 : 4.0;
    const glm::dvec4 light(reach * glm::normalize(randomPoint(random, 1.0)), round % 4 == 1 ? 0.0 : 1.0);
    EXPECT_LT(boundOf(geometry, light, Casting::EveryTriangle), 64u);
    EXPECT_LT(boundOf(geometry, light, chooseCasting(geometry, light)), 64u);
  }
}

TEST(OverlapBound, NothingCasts_IsZero)
{
  const SEDGeometry geometry = build(makePlates(1));
  EXPECT_EQ(boundOf(geometry, glm::dvec4(5, 0.1, 0, 1), Casting::EveryTriangle), 0u);
  EXPECT_EQ(boundOf(geometry, glm::dvec4(1, 0, 0, 0), Casting::EveryTriangle), 0u);
}

} // namespace shadow::test
