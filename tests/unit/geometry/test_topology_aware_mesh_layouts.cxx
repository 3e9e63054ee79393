// Valient's mesh: what it is as bytes.

#include <array>
#include <cstring>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include <glm/gtc/packing.hpp>

#include "TestMeshes.h"
#include "TopologyAwareMesh.h"

namespace shadow::test
{

namespace
{

glm::vec3 readVector(const std::vector<unsigned char>& bytes, std::size_t place)
{
  glm::vec3 value;
  std::memcpy(&value, bytes.data() + place, sizeof(value));
  return value;
}

glm::vec3 readHalves(const std::vector<unsigned char>& bytes, std::size_t place)
{
  std::array<std::uint16_t, 3> halves{};
  std::memcpy(halves.data(), bytes.data() + place, sizeof(halves));
  return {glm::unpackHalf1x16(halves[0]), glm::unpackHalf1x16(halves[1]), glm::unpackHalf1x16(halves[2])};
}

} // namespace

TEST(TopologyAwareMesh, Layouts_HaveTheirSizes)
{
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    const TopologyAwareMesh tam(geometry);
    const std::size_t faces = tam.countFaces();
    EXPECT_EQ(tam.getPackedSize(TAMLayout::Full), 3 * 84 * faces);
    EXPECT_EQ(tam.getPackedSize(TAMLayout::Half), 3 * 48 * faces);
    for (const TAMLayout layout : {TAMLayout::Full, TAMLayout::Half, TAMLayout::Shared})
    {
      EXPECT_EQ(tam.pack(geometry, layout).size(), tam.getPackedSize(layout));
    }
    const double original = static_cast<double>(getOriginalSize(geometry.getPositions().size(), faces));
    EXPECT_LE(static_cast<double>(tam.getPackedSize(TAMLayout::Shared)) / original, 0.77);
  }
  // The paper's own reckoning: unshared vertices without indices, and two vertices a face with them.
  const SEDGeometry geometry = build(makeOpenCylinder(9));
  const TopologyAwareMesh tam(geometry);
  const double half =
      static_cast<double>(tam.getPackedSize(TAMLayout::Half)) / static_cast<double>(tam.countFaces());
  EXPECT_NEAR(half / (3.0 * 44), 1.09, 0.005);
  EXPECT_NEAR(half / (static_cast<double>(getOriginalSize(20000, 10000)) / 10000), 1.53, 0.005);
}

TEST(TopologyAwareMesh, Pack_FullHoldsPositionCornersAndNormals)
{
  const SEDGeometry geometry = build(makeOpenCylinder(9));
  const TopologyAwareMesh tam(geometry);
  const std::vector<unsigned char> full = tam.pack(geometry, TAMLayout::Full);
  for (std::size_t face = 0; face < tam.countFaces(); ++face)
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const std::size_t vertex = 84 * (3 * face + corner);
      const auto& corners = geometry.getTriangles()[face];
      EXPECT_EQ(readVector(full, vertex), geometry.getPositions()[corners[corner]]);
      for (std::size_t k = 0; k < 3; ++k)
      {
        EXPECT_EQ(readVector(full, vertex + 12 + 12 * k), geometry.getPositions()[corners[k]]);
        EXPECT_EQ(readVector(full, vertex + 48 + 12 * k), tam.getNeighbourNormal(face, k));
      }
    }
  }
}

TEST(TopologyAwareMesh, Pack_HalfHoldsTheSameInHalves)
{
  const SEDGeometry geometry = build(makeOpenCylinder(9));
  const TopologyAwareMesh tam(geometry);
  const std::vector<unsigned char> full = tam.pack(geometry, TAMLayout::Full);
  const std::vector<unsigned char> half = tam.pack(geometry, TAMLayout::Half);
  const auto reach = static_cast<float>(geometry.getReach());
  for (std::size_t vertex = 0; vertex < 3 * tam.countFaces(); ++vertex)
  {
    EXPECT_EQ(readVector(half, 48 * vertex), readVector(full, 84 * vertex));
    for (std::size_t k = 0; k < 6; ++k)
    {
      const glm::vec3 exact = readVector(full, 84 * vertex + 12 + 12 * k);
      const glm::vec3 packed = readHalves(half, 48 * vertex + 12 + 6 * k);
      EXPECT_LT(glm::distance(k < 3 ? reach * packed : packed, exact), (k < 3 ? reach : 1.0f) / 1024.0f);
    }
  }
}

TEST(TopologyAwareMesh, Pack_SharedHoldsWhatIsKnownOfEachEdge)
{
  std::map<EdgeFate, std::size_t> edges;
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    const TopologyAwareMesh tam(geometry);
    const std::vector<unsigned char> shared = tam.pack(geometry, TAMLayout::Shared);
    for (std::size_t side = 0; side < 3 * tam.countFaces(); ++side)
    {
      std::uint32_t code = 0;
      std::memcpy(&code, shared.data() + 4 * side, sizeof(code));
      const EdgeFate fate = tam.getFate(geometry, side / 3, side % 3);
      ++edges[fate];
      EXPECT_EQ(code == neverPacked, fate == EdgeFate::Never);
      EXPECT_EQ(code == borderPacked, fate == EdgeFate::Border);
      if (fate == EdgeFate::Open)
      {
        // As the raster order of the face sees it.
        const glm::dvec3 neighbour(tam.getNeighbourNormal(side / 3, side % 3));
        const auto& corners = geometry.getTriangles()[side / 3];
        const auto at = [&](std::size_t k) { return glm::dvec3(geometry.getPositions()[corners[k]]); };
        const glm::dvec3 raster = glm::cross(at(1) - at(0), at(2) - at(0));
        const double turn = glm::dot(raster, glm::dvec3(tam.getNormal(side / 3))) > 0.0 ? 1.0 : -1.0;
        EXPECT_LT(glm::distance(glm::dvec3(unpackNormal(code)), turn * neighbour), 1e-4);
      }
    }
  }
  EXPECT_GT(edges[EdgeFate::Open], 100u);
  EXPECT_GT(edges[EdgeFate::Border], 100u);
  EXPECT_GT(edges[EdgeFate::Never], 10u);
}

TEST(TopologyAwareMesh, PackedNormals_AreNoCodesOfEdges)
{
  std::mt19937 random(5);
  for (int i = 0; i < 10000; ++i)
  {
    const glm::vec3 normal = glm::normalize(glm::vec3(randomPoint(random, 1.0)));
    EXPECT_NE(packNormal(normal), neverPacked);
    EXPECT_NE(packNormal(normal), borderPacked);
  }
  for (int i = 0; i < 27; ++i)
  {
    const glm::vec3 corner(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    EXPECT_NE(packNormal(corner), neverPacked) << i;
    EXPECT_NE(packNormal(corner), borderPacked) << i;
  }
}

TEST(TopologyAwareMesh, PackedNormals_KeepTheirDirection)
{
  std::mt19937 random(3);
  for (int i = 0; i < 10000; ++i)
  {
    const glm::vec3 normal = glm::normalize(glm::vec3(randomPoint(random, 1.0)));
    EXPECT_LT(glm::distance(unpackNormal(packNormal(normal)), normal), 1e-4f);
  }
  for (const glm::vec3& axis :
       {glm::vec3(1, 0, 0), glm::vec3(0, -1, 0), glm::vec3(0, 0, -1), glm::vec3(0, 0, 1)})
  {
    EXPECT_EQ(unpackNormal(packNormal(axis)), axis);
  }
}

} // namespace shadow::test
