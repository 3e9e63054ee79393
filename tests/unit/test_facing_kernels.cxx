// What instruction sets and clusters must not change.

#include <algorithm>
#include <cstdint>
#include <random>

#include <gtest/gtest.h>

#include "EdgeKernel.h"
#include "FacingDecider.h"
#include "HierarchicalSilhouette.h"
#include "SilhouetteOracle.h"
#include "TestLights.h"
#include "TestMeshes.h"

namespace shadow::test
{

namespace
{

bool isSame(const DifferingEdge& a, const DifferingEdge& b)
{
  return a.first == b.first && a.side == b.side && a.second == b.second;
}

} // namespace

TEST(PlaneBlock, EveryTriangle_HasASlotOfItsOwn)
{
  std::uint64_t taken = 0;
  for (std::size_t bit = 0; bit < PlaneBlock::triangles; ++bit)
  {
    taken |= std::uint64_t{1} << PlaneBlock::slotOf(bit);
  }
  EXPECT_EQ(taken, ~std::uint64_t{0});
}

TEST(InstructionSets, RandomPlanes_GiveTheSameWords)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<float> coordinate(-1.0f, 1.0f);
  std::vector<PlaneBlock> blocks(5);
  for (PlaneBlock& block : blocks)
  {
    for (std::size_t slot = 0; slot < PlaneBlock::triangles; ++slot)
    {
      block.x[slot] = coordinate(random);
      block.y[slot] = coordinate(random);
      block.z[slot] = coordinate(random);
      block.offset[slot] = coordinate(random);
    }
  }
  for (int round = 0; round < 100; ++round)
  {
    const ScaledLight light{coordinate(random), coordinate(random), coordinate(random), coordinate(random),
                            round % 2 == 0 ? 1e-6f : 0.3f};
    for (std::size_t word = 0; word < blocks.size(); ++word)
    {
      std::uint64_t towards = 0;
      std::uint64_t away = 0;
      for (std::size_t bit = 0; bit < PlaneBlock::triangles; ++bit)
      {
        const PlaneBlock& block = blocks[word];
        const std::size_t slot = PlaneBlock::slotOf(bit);
        const float value = (block.x[slot] * light.x + block.y[slot] * light.y) +
                            (block.z[slot] * light.z + block.offset[slot] * light.w);
        towards |= std::uint64_t{value > light.bound} << bit;
        away |= std::uint64_t{value < -light.bound} << bit;
      }
      for (const InstructionSet set : getInstructionSets())
      {
        std::vector<std::uint64_t> up(blocks.size());
        std::vector<std::uint64_t> down(blocks.size());
        getPlaneKernel(set)(blocks.data(), blocks.size(), light, up.data(), down.data());
        EXPECT_EQ(up[word], towards) << static_cast<int>(set);
        EXPECT_EQ(down[word], away) << static_cast<int>(set);
      }
    }
  }
}

TEST(InstructionSets, AnyMesh_GiveTheExactFacing)
{
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    for (const glm::dvec4& light : makeLights(geometry, 16, 2))
    {
      const LightFacing expected = faceExactly(geometry, light);
      for (const InstructionSet set : getInstructionSets())
      {
        LightFacing facing;
        facing.towards.assign(geometry.getTriangles().size());
        facing.away.assign(geometry.getTriangles().size());
        FacingDecider(geometry, light, set).decide(0, geometry.getPlaneBlocks().size(), facing);
        EXPECT_TRUE(facing.towards.getWords() == expected.towards.getWords()) << static_cast<int>(set);
        EXPECT_TRUE(facing.away.getWords() == expected.away.getWords()) << static_cast<int>(set);
      }
    }
  }
}

TEST(InstructionSets, AnyFacing_GiveTheSameEdges)
{
  std::mt19937_64 random(3);
  std::vector<NamedMesh> meshes = makeAllMeshes();
  meshes.push_back({"fine torus", makeTorus(1.0, 0.4, 50, 40)});
  for (const NamedMesh& mesh : meshes)
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    const std::size_t words = geometry.getPlaneBlocks().size();
    std::vector<std::uint64_t> towards(words);
    std::vector<std::uint64_t> away(words);
    std::generate(towards.begin(), towards.end(), random);
    std::generate(away.begin(), away.end(), random);
    for (const bool both : {false, true})
    {
      std::vector<DifferingEdge> expected;
      for (const Edge& edge : geometry.getEdges())
      {
        const auto [a, b] = edge.triangles;
        const auto differ = [a = a, b = b](const std::vector<std::uint64_t>& bits)
        { return (bits[a >> 6] >> (a & 63) & 1) != (bits[b >> 6] >> (b & 63) & 1); };
        if (b != noTriangle && (differ(towards) || (both && differ(away))))
        {
          expected.push_back({a, 0, b});
        }
      }
      for (const InstructionSet set : getInstructionSets())
      {
        std::vector<DifferingEdge> found;
        const EdgeKernels kernels = getEdgeKernels(set);
        const std::uint64_t* second = both ? away.data() : nullptr;
        kernels.compareAll(geometry.getEdgeTable(), towards.data(), second, 0, words, found);
        ASSERT_EQ(found.size(), expected.size()) << static_cast<int>(set);
        for (DifferingEdge& edge : found)
        {
          const auto side = geometry.getSide(edge.first, edge.side);
          EXPECT_NE(side[0], side[1]);
          edge.side = 0;
        }
        EXPECT_TRUE(std::is_permutation(found.begin(), found.end(), expected.begin(), isSame))
            << static_cast<int>(set);
      }
    }
  }
}

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

} // namespace shadow::test
