// Valient's mesh: what it is as bytes.

#include <cstring>
#include <random>

#include <gtest/gtest.h>

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
