// Every silhouette method finds the edges that brute force finds: on any mesh, for any light, for any bits.

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <random>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "ExactOrientation.h"
#include "HybridSilhouette.h"
#include "MeshFiles.h"
#include "SilhouetteComparison.h"
#include "TestMeshes.h"
#include "VolumeOracle.h"

namespace shadow::test
{

namespace
{

constexpr int lights = 1000;

/// Triangles between the points of a small grid: full of coplanar neighbours, crowded edges, duplicates,
/// touching fans and triangles without area.
TriangleSoup makeGridSoup(std::mt19937& random)
{
  const std::uint32_t side = 2 + random() % 3;
  TriangleSoup soup;
  for (std::uint32_t point = 0; point < side * side * side; ++point)
  {
    soup.points.emplace_back(point % side, point / side % side, point / (side * side));
  }
  const std::size_t wanted = 1 + random() % 80;
  const auto count = static_cast<std::uint32_t>(soup.points.size());
  while (soup.triangles.size() < wanted)
  {
    const std::uint32_t a = random() % count;
    // Mostly neighbours on the grid, so that edges are shared.
    const std::uint32_t b = random() % 4 == 0 ? random() % count : (a + 1 + random() % side) % count;
    const std::uint32_t c = random() % 4 == 0 ? random() % count : (a + side * (1 + random() % side)) % count;
    if (a != b && b != c && c != a)
    {
      soup.triangles.push_back({a, b, c});
    }
  }
  return soup;
}

} // namespace

TEST(SilhouetteMethods, BuiltInMesh_1000Lights_SameEdgesAsBruteForce)
{
  const auto finders = makeAllFinders();
  std::mt19937 random(11);
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    for (int light = 0; light < lights; ++light)
    {
      const LightFacing facing = computeFacing(geometry, makeLight(geometry, random, light));
      ASSERT_TRUE(expectSameEdges(geometry, facing, finders)) << "light " << light;
    }
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

TEST(SilhouetteMethods, RandomSoup_LightsAndBits_SameEdgesAsBruteForce)
{
  const auto finders = makeAllFinders();
  for (std::uint32_t seed = 0; seed < 600; ++seed)
  {
    std::mt19937 random(seed);
    const SEDGeometry geometry = build(seed % 4 == 0 ? makeRandomSoup(40, seed) : makeGridSoup(random));
    for (int round = 0; round < 24; ++round)
    {
      const LightFacing facing =
          round % 3 == 0
              ? makeRandomFacing(geometry.getTriangles().size(), random, true)
              : computeFacing(geometry, makeLight(geometry, random, static_cast<int>(random() % 8)));
      ASSERT_TRUE(expectSameEdges(geometry, facing, finders)) << "seed " << seed << ", round " << round;
    }
  }
}

TEST(SilhouetteMethods, RandomSoup_NoEdgeMissingOrExtraByExactArithmetic)
{
  const auto finders = makeAllFinders();
  for (std::uint32_t seed = 1000; seed < 1100; ++seed)
  {
    std::mt19937 random(seed);
    const SEDGeometry geometry = build(makeGridSoup(random));
    const std::vector<std::uint32_t> first = findFirstAtPosition(geometry);
    const std::vector<glm::vec3>& p = geometry.getPositions();
    // Off the grid, so that no vertex is at the light.
    const glm::dvec4 light(randomPoint(random, 4.0), seed % 2);
    EdgeBalance exact;
    for (const auto& c : geometry.getTriangles())
    {
      exact.addTriangle({first[c[0]], first[c[1]], first[c[2]]},
                        exactOrientation(p[c[0]], p[c[1]], p[c[2]], light));
    }
    for (const auto& finder : finders)
    {
      EdgeBalance found;
      for (const SilhouetteEdge& edge :
           finder->find(geometry, computeFacing(geometry, light), Casting::EveryTriangle))
      {
        found.add(first[edge.from], first[edge.to], static_cast<int>(edge.multiplicity));
      }
      ASSERT_EQ(exact.get(), found.get()) << "seed " << seed;
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

TEST(SilhouetteMethods, HaveDistinctNamesAndFinders)
{
  std::set<std::string> names;
  std::set<std::uint64_t> ids;
  for (const SilhouetteMethod method : otherMethods())
  {
    names.insert(toString(method));
    ids.insert(makeSilhouetteFinder(method)->getId());
  }
  EXPECT_EQ(names.size(), otherMethods().size());
  EXPECT_EQ(ids.size(), otherMethods().size()) << "an id came up twice";
  EXPECT_EQ(names.count("brute-force"), 0u);
  for (const char* name : {"edge-buffer", "triangular", "visible-nonvisible", "hybrid"})
  {
    EXPECT_EQ(names.count(name), 1u) << name;
  }
}

class MeshFileSilhouettes : public testing::TestWithParam<std::string>
{
};

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(MeshFileSilhouettes);

TEST_P(MeshFileSilhouettes, MethodsOn1000Lights_SameEdgesAsBruteForce)
{
  const auto finders = makeAllFinders();
  const SEDGeometry geometry = build(readMeshFile(GetParam()));
  std::mt19937 random(14);
  for (int light = 0; light < lights; ++light)
  {
    const LightFacing facing = computeFacing(geometry, makeLight(geometry, random, light));
    ASSERT_TRUE(expectSameEdges(geometry, facing, finders)) << "light " << light;
  }
}

INSTANTIATE_TEST_SUITE_P(Models, MeshFileSilhouettes, testing::ValuesIn(findMeshFiles(SHADOW_MODELS)),
                         [](const auto& test)
                         {
                           std::string name = std::filesystem::path(test.param).stem().string();
                           std::replace_if(
                               name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; },
                               '_');
                           return name;
                         });

} // namespace shadow::test
