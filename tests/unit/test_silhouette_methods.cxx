// Every silhouette method finds the same bits and edges, and those of exact arithmetic.

#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "SilhouetteFinder.h"
#include "SilhouetteOracle.h"

namespace shadow::test
{

namespace
{

constexpr std::size_t thousand = 1000;

/// A sphere with dents, large enough for several levels of clusters.
TriangleSoup makeDentedSphere()
{
  TriangleSoup soup = makeSphere(1.0, 120, 100);
  for (glm::dvec3& point : soup.points)
  {
    point *= 1.0 + 0.03 * std::sin(17.0 * point.x) * std::sin(13.0 * point.y) * std::sin(11.0 * point.z);
  }
  return soup;
}

/// The small meshes, and some of many clusters: smooth, dented, open, flat, random.
std::vector<NamedMesh> makeMeshes()
{
  std::vector<NamedMesh> meshes = makeAllMeshes();
  TriangleSoup halfOpen = makeTorus(1.0, 0.4, 80, 40);
  halfOpen.triangles.resize(halfOpen.triangles.size() * 3 / 5);
  TriangleSoup twice = makeSphere(1.0, 40, 30);
  append(twice, makeSphere(1.0, 40, 30));
  meshes.push_back({"fine torus", makeTorus(1.0, 0.4, 100, 50)});
  meshes.push_back({"dented sphere", makeDentedSphere()});
  meshes.push_back({"open torus", halfOpen});
  meshes.push_back({"many plates", makePlates(300)});
  meshes.push_back({"large soup", makeRandomSoup(3000, 3)});
  meshes.push_back({"fine sphere twice", twice});
  return meshes;
}

std::string describe(std::size_t light, const glm::dvec4& at, SilhouetteMethod method)
{
  return toString(method) + ", light " + std::to_string(light) + ": " + std::to_string(at.x) + " " +
         std::to_string(at.y) + " " + std::to_string(at.z) + " " + std::to_string(at.w);
}

/// @return  false when a method differs, which it has then reported
bool expectSameAs(const SEDGeometry& geometry, const LightFacing& expected, const glm::dvec4& light,
                  const std::string& where, const SilhouetteFinder& finder, LightFacing& facing)
{
  finder.face(geometry, light, facing);
  EXPECT_EQ(facing.towards.size(), geometry.getTriangles().size()) << where;
  EXPECT_TRUE(facing.towards.getWords() == expected.towards.getWords()) << where;
  EXPECT_TRUE(facing.away.getWords() == expected.away.getWords()) << where;
  return !testing::Test::HasFailure();
}

/// All methods against brute force, for the facing that each hands on.
void expectSameEdges(const SEDGeometry& geometry, std::size_t count, std::uint32_t seed)
{
  const auto bruteForce = makeSilhouetteFinder(SilhouetteMethod::BruteForce);
  LightFacing expected;
  LightFacing facing; // shared, as what a method left there must not matter to the next one
  const std::vector<glm::dvec4> lights = makeLights(geometry, count, seed);
  for (std::size_t index = 0; index < lights.size(); ++index)
  {
    bruteForce->face(geometry, lights[index], expected);
    for (const Casting casting : {Casting::LightFacing, Casting::EveryTriangle})
    {
      const auto edges = bruteForce->find(geometry, expected, casting);
      for (const SilhouetteMethod method : getSilhouetteMethods())
      {
        const auto finder = makeSilhouetteFinder(method);
        const std::string where = describe(index, lights[index], method);
        if (!expectSameAs(geometry, expected, lights[index], where, *finder, facing))
        {
          return;
        }
        const auto found = finder->find(geometry, facing, casting);
        ASSERT_TRUE(areSame(found, edges)) << where;
      }
    }
  }
}

/// All methods against exact arithmetic and the sum over all triangles.
void expectExactEdges(const SEDGeometry& geometry, const std::vector<glm::dvec4>& lights)
{
  LightFacing facing;
  for (std::size_t index = 0; index < lights.size(); ++index)
  {
    const LightFacing exact = faceExactly(geometry, lights[index]);
    for (const Casting casting : {Casting::LightFacing, Casting::EveryTriangle})
    {
      const EdgeBalance expected = sumSides(geometry, exact, casting);
      for (const SilhouetteMethod method : getSilhouetteMethods())
      {
        const auto finder = makeSilhouetteFinder(method);
        const std::string where = describe(index, lights[index], method);
        if (!expectSameAs(geometry, exact, lights[index], where, *finder, facing))
        {
          return;
        }
        const auto found = finder->find(geometry, facing, casting);
        ASSERT_EQ(sumSilhouette(found).get(), expected.get()) << where;
      }
    }
  }
}

} // namespace

TEST(SilhouetteMethods, BuiltInMeshes_ThousandLights_GiveTheSameEdges)
{
  for (const NamedMesh& mesh : makeMeshes())
  {
    SCOPED_TRACE(mesh.name);
    expectSameEdges(build(mesh.soup), thousand, 1);
  }
}

TEST(SilhouetteMethods, SharedMeshes_ThousandLights_GiveTheSameEdges)
{
  for (const NamedMesh& mesh : findSharedMeshes())
  {
    SCOPED_TRACE(mesh.name);
    expectSameEdges(build(mesh.soup), thousand, 2);
  }
}

TEST(SilhouetteMethods, BuiltInMeshes_MissNoEdgeAndAddNone)
{
  for (const NamedMesh& mesh : makeMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    expectExactEdges(geometry, makeLights(geometry, mesh.soup.triangles.size() < 2000 ? 160 : 16, 3));
  }
}

TEST(SilhouetteMethods, SharedMeshes_MissNoEdgeAndAddNone)
{
  for (const NamedMesh& mesh : findSharedMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    expectExactEdges(geometry, makeLights(geometry, 8, 4));
  }
}

TEST(SilhouetteMethods, Fuzz_RandomSoups_MissNoEdgeAndAddNone)
{
  std::mt19937 random(5);
  for (int round = 0; round < 400; ++round)
  {
    SCOPED_TRACE(round);
    // Few points make many triangles share an edge, whole coordinates many lie in one plane, and one
    // squeezed axis slivers.
    const std::uint32_t points = 4 + random() % 60;
    const std::uint32_t triangles = 1 + random() % 300;
    const bool whole = round % 2 == 0;
    const double scale = std::pow(10.0, static_cast<int>(random() % 16) - 6);
    const double squeeze = round % 3 == 0 ? 1e-5 : 1.0;
    TriangleSoup soup;
    for (std::uint32_t point = 0; point < points; ++point)
    {
      const glm::dvec3 place = randomPoint(random, 4.0) * glm::dvec3(1.0, squeeze, 1.0);
      soup.points.push_back(whole ? glm::round(place) : scale * place);
    }
    for (std::uint32_t triangle = 0; triangle < triangles; ++triangle)
    {
      soup.triangles.push_back({static_cast<std::uint32_t>(random() % points),
                                static_cast<std::uint32_t>(random() % points),
                                static_cast<std::uint32_t>(random() % points)});
    }
    std::string error;
    const std::optional<SEDGeometry> geometry = buildSEDGeometry(soup, {}, error);
    if (!geometry)
    {
      continue; // every triangle happened to be degenerate
    }
    std::vector<glm::dvec4> lights = makeLights(*geometry, 8, round);
    lights.emplace_back(glm::round(randomPoint(random, 6.0)), 1.0);
    lights.emplace_back(glm::round(randomPoint(random, 3.0)), 0.0);
    expectExactEdges(*geometry, lights);
  }
}

TEST(SilhouetteMethods, FacingFromElsewhere_GivesTheSameEdges)
{
  std::mt19937 random(6);
  for (const NamedMesh& mesh : makeMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    LightFacing facing;
    facing.towards.assign(geometry.getTriangles().size());
    facing.away.assign(geometry.getTriangles().size());
    for (std::size_t t = 0; t < geometry.getTriangles().size(); ++t)
    {
      const std::uint32_t side = random() % 3;
      if (side < 2)
      {
        (side == 0 ? facing.towards : facing.away).set(t);
      }
    }
    for (const Casting casting : {Casting::LightFacing, Casting::EveryTriangle})
    {
      const EdgeBalance expected = sumSides(geometry, facing, casting);
      for (const SilhouetteMethod method : getSilhouetteMethods())
      {
        EXPECT_EQ(sumSilhouette(makeSilhouetteFinder(method)->find(geometry, facing, casting)).get(),
                  expected.get())
            << toString(method);
      }
    }
  }
}

TEST(SilhouetteMethods, AnyOrderOfParts_GivesTheSameEdges)
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
  LightFacing expected;
  LightFacing facing;
  for (const glm::dvec4& light : makeLights(geometry, 16, 7))
  {
    makeSilhouetteFinder(SilhouetteMethod::BruteForce)->face(geometry, light, expected);
    for (const SilhouetteMethod method : getSilhouetteMethods())
    {
      const auto finder = makeSilhouetteFinder(method, backwards);
      finder->face(geometry, light, facing);
      EXPECT_TRUE(facing.towards.getWords() == expected.towards.getWords()) << toString(method);
      EXPECT_TRUE(facing.away.getWords() == expected.away.getWords()) << toString(method);
      for (const Casting casting : {Casting::LightFacing, Casting::EveryTriangle})
      {
        EXPECT_TRUE(
            areSame(finder->find(geometry, facing, casting),
                    makeSilhouetteFinder(SilhouetteMethod::BruteForce)->find(geometry, expected, casting)))
            << toString(method);
      }
    }
  }
  EXPECT_GT(calls, 2u);
}

TEST(SilhouetteMethods, LightWithoutAPlace_LightsNothing)
{
  const SEDGeometry geometry = build(makeTorus(1.0, 0.4, 40, 20));
  LightFacing facing;
  for (const SilhouetteMethod method : getSilhouetteMethods())
  {
    const auto finder = makeSilhouetteFinder(method);
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
  const auto named = makeSilhouetteFinder(SilhouetteMethod::Hierarchical);
  EXPECT_EQ(named->getMethod(build(makeCube())), SilhouetteMethod::Hierarchical);
}

} // namespace shadow::test
