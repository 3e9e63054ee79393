// Every silhouette method misses no edge and adds none: against exact arithmetic of the tests' own, and the
// sum over all triangles, with no table of edges.

#include <cstddef>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "MeshFamilies.h"
#include "MeshFiles.h"
#include "SilhouetteComparison.h"
#include "SilhouetteOracle.h"
#include "TestLights.h"

namespace shadow::test
{

namespace
{

using Finders = std::vector<std::unique_ptr<SilhouetteFinder>>;

/// Whether all finders find the sides that do not cancel; what differs has been reported.
bool expectSumOfSides(const SEDGeometry& geometry, const LightFacing& facing, const LightFacing& expected,
                      const SilhouetteFinder& finder)
{
  for (const Casting casting : {Casting::LightFacing, Casting::EveryTriangle})
  {
    EXPECT_EQ(sumSilhouette(finder.find(geometry, facing, casting)).get(),
              sumSides(geometry, expected, casting).get())
        << toString(finder.getMethod(geometry));
  }
  return !testing::Test::HasFailure();
}

void expectExactEdges(const SEDGeometry& geometry, const std::vector<glm::dvec4>& lights,
                      const Finders& finders)
{
  LightFacing facing; // shared, as what a method left there must not matter to the next one
  for (std::size_t index = 0; index < lights.size(); ++index)
  {
    SCOPED_TRACE("light " + std::to_string(index));
    const LightFacing exact = faceExactly(geometry, lights[index]);
    for (const auto& finder : finders)
    {
      finder->face(geometry, lights[index], facing);
      ASSERT_TRUE(facing.towards.getWords() == exact.towards.getWords());
      ASSERT_TRUE(facing.away.getWords() == exact.away.getWords());
      ASSERT_TRUE(expectSumOfSides(geometry, facing, exact, *finder));
    }
  }
}

} // namespace

TEST(SilhouetteOracle, BuiltInMesh_NoEdgeMissingOrExtra)
{
  const Finders finders = makeAllFinders();
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    expectExactEdges(geometry, makeLights(geometry, 160, 3), finders);
  }
}

TEST(SilhouetteOracle, LargeMesh_NoEdgeMissingOrExtra)
{
  const Finders finders = makeAllFinders();
  for (const NamedMesh& mesh : makeLargeMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    expectExactEdges(geometry, makeLights(geometry, lightKinds, 3), finders);
  }
}

TEST(SilhouetteOracle, GridSoup_NoEdgeMissingOrExtra)
{
  const Finders finders = makeAllFinders();
  for (std::uint32_t seed = 1000; seed < 1100; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const SEDGeometry geometry = build(makeGridSoup(random));
    expectExactEdges(geometry, makeLights(geometry, lightKinds, seed), finders);
  }
}

TEST(SilhouetteOracle, CrowdedSoup_NoEdgeMissingOrExtra)
{
  const Finders finders = makeAllFinders();
  std::mt19937 random(5);
  for (std::uint32_t round = 0; round < 400; ++round)
  {
    SCOPED_TRACE(round);
    std::string error;
    const std::optional<SEDGeometry> geometry = buildSEDGeometry(makeCrowdedSoup(random), {}, error);
    if (!geometry)
    {
      continue; // every triangle happened to be degenerate
    }
    std::vector<glm::dvec4> lights = makeLights(*geometry, lightKinds, round);
    lights.emplace_back(glm::round(randomPoint(random, 6.0)), 1.0);
    lights.emplace_back(glm::round(randomPoint(random, 3.0)), 0.0);
    expectExactEdges(*geometry, lights, finders);
  }
}

TEST(SilhouetteOracle, AnyFacingBits_NoEdgeMissingOrExtra)
{
  const Finders finders = makeAllFinders();
  std::mt19937 random(6);
  for (const auto& meshes : {makeAllMeshes(), makeLargeMeshes()})
  {
    for (const NamedMesh& mesh : meshes)
    {
      SCOPED_TRACE(mesh.name);
      const SEDGeometry geometry = build(mesh.soup);
      const LightFacing facing = makeRandomFacing(geometry.getTriangles().size(), random, true);
      for (const auto& finder : finders)
      {
        EXPECT_TRUE(expectSumOfSides(geometry, facing, facing, *finder));
      }
    }
  }
}

class MeshFileOracle : public testing::TestWithParam<std::string>
{
};

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(MeshFileOracle);

TEST_P(MeshFileOracle, NoEdgeMissingOrExtra)
{
  const SEDGeometry geometry = build(readMeshFile(GetParam()));
  expectExactEdges(geometry, makeLights(geometry, lightKinds, 4), makeAllFinders());
}

INSTANTIATE_TEST_SUITE_P(Models, MeshFileOracle, testing::ValuesIn(findMeshFiles(SHADOW_MODELS)),
                         [](const auto& test) { return toTestName(test.param); });

} // namespace shadow::test
