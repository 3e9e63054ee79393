// What clusters must not change, and how little they leave to look at.

#include <algorithm>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "FacingDecider.h"
#include "HierarchicalSilhouette.h"
#include "SilhouetteOracle.h"
#include "TestLights.h"
#include "TestMeshes.h"

namespace shadow::test
{

TEST(ClusterTree, SmoothMesh_LooksAtFewWordsOnly)
{
  // Twice the edge length is four times the triangles and twice the silhouette.
  std::size_t mixed = 0;
  for (const std::uint32_t across : {100u, 200u, 400u})
  {
    const SEDGeometry geometry = build(makeTorus(1.0, 0.4, 2 * across, across));
    LightFacing facing;
    HierarchicalSilhouette().face(geometry, {1.2, -2.0, 0.7, 1.0}, facing);
    ASSERT_TRUE(facing.mixedWords.has_value());
    EXPECT_LT(facing.mixedWords->size(), geometry.getPlaneBlocks().size() * 80 / across);
    EXPECT_TRUE(std::is_sorted(facing.mixedWords->begin(), facing.mixedWords->end()));
    if (mixed > 0)
    {
      EXPECT_LT(static_cast<double>(facing.mixedWords->size()), 2.6 * static_cast<double>(mixed));
    }
    mixed = facing.mixedWords->size();
  }
}

TEST(ClusterTree, SmoothMesh_ReadsFewQuartersOfThese)
{
  const SEDGeometry geometry = build(makeTorus(1.0, 0.4, 400, 200));
  const std::size_t triangles = geometry.getTriangles().size();
  FacingBits towards(triangles);
  FacingBits away(triangles);
  std::vector<ClusterTree::Quarters> mixed;
  const FacingDecider decider(geometry, {1.2, -2.0, 0.7, 1.0});
  geometry.getClusterTree().classify(decider.getScaledLight(), towards, away, mixed);
  std::size_t quarters = 0;
  for (const ClusterTree::Quarters& word : mixed)
  {
    for (std::uint32_t bits = word.bits; bits != 0; bits &= bits - 1)
    {
      ++quarters;
    }
  }
  ASSERT_GT(mixed.size(), 20u);
  EXPECT_LT(quarters, 3 * mixed.size());
}

TEST(ClusterTree, AnyInstructionSet_BitsAreExactWhereThereAreAny)
{
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    const std::size_t triangles = geometry.getTriangles().size();
    for (const glm::dvec4& light : makeLights(geometry, 16, 4))
    {
      const LightFacing exact = faceExactly(geometry, light);
      const FacingDecider decider(geometry, light);
      for (const InstructionSet set : getInstructionSets())
      {
        FacingBits towards(triangles);
        FacingBits away(triangles);
        std::vector<ClusterTree::Quarters> mixed;
        geometry.getClusterTree().classify(decider.getScaledLight(), towards, away, mixed, set);
        std::vector<std::uint64_t> open(towards.getWords().size(), 0);
        for (const auto& [word, quarters] : mixed)
        {
          for (std::uint32_t quarter = 0; quarter < 4; ++quarter)
          {
            open[word] |= (quarters >> quarter & 1u) != 0 ? std::uint64_t{0xffff} << 16 * quarter : 0;
          }
        }
        for (std::size_t word = 0; word < open.size(); ++word)
        {
          EXPECT_EQ(towards.getWords()[word], exact.towards.getWords()[word] & ~open[word]);
          EXPECT_EQ(away.getWords()[word], exact.away.getWords()[word] & ~open[word]);
        }
      }
    }
  }
}

TEST(ClusterTree, SiblingsAtOppositeEnds_FaceAsExactly)
{
  // Seven clusters at one end and one at the other: from the centre of all of them its planes pass farther
  // away than a bound can say.
  TriangleSoup soup;
  const auto addSheet = [&soup](double x, int triangles)
  {
    for (int triangle = 0; triangle < triangles; ++triangle)
    {
      const auto first = static_cast<std::uint32_t>(soup.points.size());
      const glm::dvec3 corner(x, 1e-3 * (triangle % 12), 1e-3 * (triangle / 12));
      soup.points.insert(soup.points.end(),
                         {corner, corner + glm::dvec3(0.0, 9e-4, 0.0), corner + glm::dvec3(0.0, 0.0, 9e-4)});
      soup.triangles.push_back({first, first + 1, first + 2});
    }
  };
  // Just below a power of two, which lengths are stored relative to.
  addSheet(-0.96, 7 * 16);
  addSheet(0.96, 2 * 16);
  const SEDGeometry geometry = build(soup);
  ASSERT_EQ(geometry.getReach(), 1.0);
  for (const double x : {-3.0, -0.961, -0.959, -0.5, 0.0, 0.5, 0.959, 0.961, 3.0})
  {
    for (const double w : {0.0, 1.0})
    {
      const glm::dvec4 light(glm::dvec3(x, 0.3, 0.2) - w * geometry.getOrigin(), w);
      const LightFacing expected = faceExactly(geometry, light);
      LightFacing facing;
      HierarchicalSilhouette().face(geometry, light, facing);
      EXPECT_TRUE(facing.towards.getWords() == expected.towards.getWords()) << x << ", " << w;
      EXPECT_TRUE(facing.away.getWords() == expected.away.getWords()) << x << ", " << w;
    }
  }
}

} // namespace shadow::test
