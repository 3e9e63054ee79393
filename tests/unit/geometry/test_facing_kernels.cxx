// What instruction sets must not change.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include <gtest/gtest.h>

#include "EdgeKernel.h"
#include "FacingDecider.h"
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
  std::uniform_int_distribution<std::int16_t> units(-18000, 18000);
  std::vector<PlaneBlock> blocks(5);
  for (PlaneBlock& block : blocks)
  {
    for (std::size_t slot = 0; slot < PlaneBlock::triangles; ++slot)
    {
      block.xy[slot] = {units(random), units(random)};
      block.zOffset[slot] = {units(random), units(random)};
    }
  }
  for (int round = 0; round < 100; ++round)
  {
    const LightInUnits light{units(random), units(random), units(random), units(random),
                             round % 2 == 0 ? 100 : 300000000};
    for (std::size_t word = 0; word < blocks.size(); ++word)
    {
      std::uint64_t towards = 0;
      std::uint64_t away = 0;
      for (std::size_t bit = 0; bit < PlaneBlock::triangles; ++bit)
      {
        const glm::dvec4 plane = blocks[word].get(bit) * PlaneBlock::unitsInOne;
        const double value = glm::dot(plane, glm::dvec4(light.x, light.y, light.z, light.w));
        towards |= std::uint64_t{value > light.bound} << bit;
        away |= std::uint64_t{value < -light.bound} << bit;
      }
      for (const InstructionSet set : getInstructionSets())
      {
        std::vector<std::uint64_t> up(blocks.size());
        std::vector<std::uint64_t> down(blocks.size());
        const PlaneKernel kernel = getPlaneKernel(set);
        kernel.compareBlocks(blocks.data(), blocks.size(), light, up.data(), down.data());
        EXPECT_EQ(up[word], towards) << static_cast<int>(set);
        EXPECT_EQ(down[word], away) << static_cast<int>(set);
        // Two quarters of four, and the others in a second call.
        std::uint64_t upInParts = 0;
        std::uint64_t downInParts = 0;
        for (const unsigned int quarters : {0x5u, 0xau})
        {
          kernel.compareQuarters(blocks[word], quarters, light, upInParts, downInParts);
          const std::uint64_t done = quarters == 0x5 ? 0x0000ffff0000ffffu : ~std::uint64_t{0};
          EXPECT_EQ(upInParts, towards & done) << static_cast<int>(set);
          EXPECT_EQ(downInParts, away & done) << static_cast<int>(set);
        }
      }
    }
  }
}

TEST(LightInUnits, LightWithoutDirection_IsAllZeros)
{
  const double notANumber = std::nan("");
  for (const glm::dvec4& light :
       {glm::dvec4(0.0), glm::dvec4(notANumber, 0.0, 1.0, 0.0), glm::dvec4(1e-320, 0.0, 0.0, 0.0)})
  {
    const LightInUnits inUnits = toUnits(scaleLight(light, 1.0));
    EXPECT_TRUE(inUnits.x == 0 && inUnits.y == 0 && inUnits.z == 0 && inUnits.w == 0 && inUnits.bound == 0);
  }
}

TEST(LightInUnits, AnyLight_DoesNotOverflowAndBoundsTheError)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  for (int round = 0; round < 20000; ++round)
  {
    const double reach = std::ldexp(1.0, round % 41 - 20);
    glm::dvec4 light(coordinate(random), coordinate(random), coordinate(random), round % 3 == 0 ? 0.0 : 1.0);
    light = glm::dvec4(glm::dvec3(light) * std::ldexp(reach, round % 17 - 8), light.w);
    if (round % 5 == 0)
    {
      // One product is all there is, as large as it gets.
      light.x = light.y = 0.0;
    }
    const ScaledLight scaled = scaleLight(light, reach);
    const LightInUnits inUnits = toUnits(scaled);
    const glm::dvec4 inReach(glm::dvec3(light), light.w * reach);
    for (int other = 0; other < 20; ++other)
    {
      // Half of the planes lie as the light does, where values are largest.
      glm::dvec3 normal(coordinate(random), coordinate(random), coordinate(random));
      normal = glm::normalize(other % 2 == 0 ? normal : glm::dvec3(light));
      const double offset = other % 4 == 1 ? 1.0 : coordinate(random);
      PlaneBlock block;
      block.set(5, normal, offset);
      const glm::dvec4 units = glm::round(block.get(5) * PlaneBlock::unitsInOne);
      const double value = glm::dot(units, glm::dvec4(inUnits.x, inUnits.y, inUnits.z, inUnits.w));
      ASSERT_LT(std::abs(value), 0x1p31);
      const double exact = glm::dot(glm::dvec4(normal, offset), inReach);
      if (value > inUnits.bound)
      {
        ASSERT_GT(exact, 0.0);
      }
      else if (value < -inUnits.bound)
      {
        ASSERT_LT(exact, 0.0);
      }
      // No more is left open than has to be.
      else
      {
        ASSERT_LT(std::abs(exact), 5e-4 * glm::length(inReach));
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
    // Words whose triangles are all alike, with and without neighbours of the same kind.
    for (std::size_t word = 0; word < words; word += 3)
    {
      towards[word] = random() % 2 == 0 ? 0 : ~std::uint64_t{0};
      away[word] = word % 2 == 0 ? ~towards[word] : away[word];
    }
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
        std::vector<DifferingEdge> found(words * EdgeTable::mostOfWord);
        const std::uint64_t* second = both ? away.data() : nullptr;
        const DifferingEdge* end =
            getEdgeKernel(set)(geometry.getEdgeTable(), towards.data(), second, 0, words, found.data());
        found.resize(static_cast<std::size_t>(end - found.data()));
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

} // namespace shadow::test
