// Every silhouette method finds the bits and edges that brute force finds: on any mesh, for any light, for
// any bits.

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "HybridSilhouette.h"
#include "MeshFamilies.h"
#include "MeshFiles.h"
#include "SilhouetteComparison.h"
#include "TestLights.h"

namespace shadow::test
{

namespace
{

constexpr int thousand = 1000;

void expectSameAnswersForLights(const SEDGeometry& geometry, std::uint32_t seed)
{
  const auto finders = makeAllFinders();
  std::mt19937 random(seed);
  for (int light = 0; light < thousand; ++light)
  {
    ASSERT_TRUE(expectSameAnswers(geometry, makeLight(geometry, random, light), finders))
        << "light " << light;
  }
}

} // namespace

TEST(SilhouetteMethods, BuiltInMesh_1000Lights_SameAsBruteForce)
{
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    expectSameAnswersForLights(build(mesh.soup), 11);
  }
}

TEST(SilhouetteMethods, LargeMesh_1000Lights_SameAsBruteForce)
{
  for (const NamedMesh& mesh : makeLargeMeshes())
  {
    SCOPED_TRACE(mesh.name);
    expectSameAnswersForLights(build(mesh.soup), 1);
  }
}

TEST(SilhouetteMethods, BuiltInMesh_AnyFacingBits_SameEdgesAsBruteForce)
{
  const auto finders = makeAllFinders();
  std::mt19937 random(12);
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    for (int round = 0; round < 100; ++round)
    {
      const LightFacing facing = makeRandomFacing(geometry.getTriangles().size(), random, round % 2 == 1);
      ASSERT_TRUE(expectSameEdges(geometry, facing, finders)) << "round " << round;
    }
  }
}

TEST(SilhouetteMethods, RandomSoup_LightsAndBits_SameAsBruteForce)
{
  const auto finders = makeAllFinders();
  for (std::uint32_t seed = 0; seed < 600; ++seed)
  {
    std::mt19937 random(seed);
    const SEDGeometry geometry = build(seed % 4 == 0 ? makeRandomSoup(40, seed) : makeGridSoup(random));
    for (int round = 0; round < 24; ++round)
    {
      const bool anyBits = round % 3 == 0;
      const LightFacing facing =
          anyBits ? makeRandomFacing(geometry.getTriangles().size(), random, true) : LightFacing();
      const glm::dvec4 light = makeLight(geometry, random, static_cast<int>(random() % lightKinds));
      ASSERT_TRUE(anyBits ? expectSameEdges(geometry, facing, finders)
                          : expectSameAnswers(geometry, light, finders))
          << "seed " << seed << ", round " << round;
    }
  }
}

TEST(SilhouetteMethods, HybridWithTolerance_IsExactForTheFacingHandedIn)
{
  std::vector<std::unique_ptr<SilhouetteFinder>> finders;
  finders.push_back(makeSilhouetteFinder(SilhouetteMethod::BruteForce));
  finders.push_back(std::make_unique<HybridSilhouette>(40.0));
  std::mt19937 random(13);
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    for (int light = 0; light < 200; ++light)
    {
      const LightFacing facing = computeFacing(geometry, makeLight(geometry, random, light));
      ASSERT_TRUE(expectSameEdges(geometry, facing, finders));
      const std::optional<LightFacing> simplified = finders[1]->simplifyFacing(geometry, facing);
      ASSERT_TRUE(simplified.has_value());
      ASSERT_TRUE(expectSameEdges(geometry, *simplified, finders));
    }
  }
}

TEST(SilhouetteMethods, FacingOfHierarchical_IsTakenByEveryMethod)
{
  // What it notes beside the bits must not lead another method astray, nor outlive a change of the bits.
  const auto finders = makeAllFinders();
  const HybridSilhouette simplifier(40.0);
  const SEDGeometry geometry = build(makeTorus(1.0, 0.4, 100, 50));
  std::mt19937 random(15);
  LightFacing facing;
  for (int light = 0; light < 100; ++light)
  {
    const glm::dvec4 lightMC = makeLight(geometry, random, light);
    makeSilhouetteFinder(SilhouetteMethod::Hierarchical)->face(geometry, lightMC, facing);
    ASSERT_TRUE(expectSameEdges(geometry, facing, finders)) << "light " << light;
    ASSERT_TRUE(expectSameEdges(geometry, *simplifier.simplifyFacing(geometry, facing), finders))
        << "simplified, light " << light;
    facing.mixedWords.reset();
    facing.towards.data()[light % facing.towards.getWords().size()] &= 0xffff00ffff0000ffu;
    ASSERT_TRUE(expectSameEdges(geometry, facing, finders)) << "light " << light;
  }
}

TEST(SilhouetteMethods, AnyOrderOfParts_SameAsBruteForce)
{
  // Large enough for several parts; in the reverse order, as threads might take them.
  const SEDGeometry geometry = build(makeTorus(1.0, 0.4, 600, 300));
  std::size_t calls = 0;
  const ParallelFor backwards = [&calls](std::size_t count, const auto& part)
  {
    for (std::size_t index = count; index > 0; --index)
    {
      part(index - 1, index);
      ++calls;
    }
  };
  std::vector<std::unique_ptr<SilhouetteFinder>> finders = makeAllFinders();
  for (const SilhouetteMethod method : getSilhouetteMethods())
  {
    if (!isOnGPU(method))
    {
      finders.push_back(makeSilhouetteFinder(method, 0.0, backwards));
    }
  }
  for (const glm::dvec4& light : makeLights(geometry, lightKinds, 7))
  {
    ASSERT_TRUE(expectSameAnswers(geometry, light, finders));
  }
  EXPECT_GT(calls, 2u);
}

TEST(SilhouetteMethods, LightWithoutAPlace_LightsNothing)
{
  const SEDGeometry geometry = build(makeTorus(1.0, 0.4, 40, 20));
  LightFacing facing;
  for (const auto& finder : makeAllFinders())
  {
    finder->face(geometry, {3, 4, 5, 1}, facing);
    ASSERT_GT(facing.towards.countSet(), 0u);
    for (const glm::dvec4 light :
         {glm::dvec4(0.0), glm::dvec4(0, std::nan(""), 1, 1), glm::dvec4(0, 0, HUGE_VAL, 0)})
    {
      finder->face(geometry, light, facing);
      EXPECT_EQ(facing.towards.countSet() + facing.away.countSet(), 0u);
      EXPECT_TRUE(finder->find(geometry, facing, Casting::LightFacing).empty());
      EXPECT_TRUE(finder->find(geometry, facing, Casting::EveryTriangle).empty());
    }
  }
}

TEST(SilhouetteMethods, Auto_TakesWhatSuitsTheSize)
{
  const auto finder = makeSilhouetteFinder(SilhouetteMethod::Auto);
  EXPECT_EQ(finder->getMethod(build(makeCube())), SilhouetteMethod::BruteForce);
  EXPECT_EQ(finder->getMethod(build(makeTorus(1.0, 0.4, 200, 100))), SilhouetteMethod::Hierarchical);
}

TEST(SilhouetteMethods, HaveDistinctNamesAndFinders)
{
  const SEDGeometry cube = build(makeCube());
  std::set<std::string> names;
  std::set<std::uint64_t> ids;
  for (const SilhouetteMethod method : getSilhouetteMethods())
  {
    names.insert(toString(method));
    if (isOnGPU(method))
    {
      EXPECT_THROW(makeSilhouetteFinder(method), std::invalid_argument) << toString(method);
      continue;
    }
    const auto finder = makeSilhouetteFinder(method);
    EXPECT_TRUE(ids.insert(finder->getId()).second) << "an id came up twice";
    EXPECT_EQ(finder->getMethod(cube),
              method == SilhouetteMethod::Auto ? SilhouetteMethod::BruteForce : method);
  }
  EXPECT_EQ(names.size(), getSilhouetteMethods().size());
  for (const char* name :
       {"auto", "brute-force", "edge-buffer", "triangular", "visible-nonvisible", "hybrid", "hierarchical",
        "topology-aware-mesh", "facing-texture", "facing-texture-resident", "vertex-extrusion"})
  {
    EXPECT_EQ(names.count(name), 1u) << name;
  }
}

class MeshFileSilhouettes : public testing::TestWithParam<std::string>
{
};

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(MeshFileSilhouettes);

TEST_P(MeshFileSilhouettes, MethodsOn1000Lights_SameAsBruteForce)
{
  expectSameAnswersForLights(build(readMeshFile(GetParam())), 14);
}

INSTANTIATE_TEST_SUITE_P(Models, MeshFileSilhouettes, testing::ValuesIn(findMeshFiles(SHADOW_MODELS)),
                         [](const auto& test) { return toTestName(test.param); });

} // namespace shadow::test
