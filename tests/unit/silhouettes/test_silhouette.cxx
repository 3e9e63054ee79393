// Laws of silhouettes: they are closed, and equal to the sum over single triangles.

#include <memory>
#include <random>

#include <gtest/gtest.h>

#include "ExactOrientation.h"
#include "SilhouetteComparison.h"
#include "SilhouetteFinder.h"
#include "TestMeshes.h"
#include "VolumeOracle.h"

namespace shadow::test
{

namespace
{

std::vector<SilhouetteEdge> find(const SEDGeometry& geometry, const LightFacing& facing, Casting casting)
{
  return makeSilhouetteFinder(SilhouetteMethod::BruteForce)->find(geometry, facing, casting);
}

void expectBalanced(const SEDGeometry& geometry, const std::vector<SilhouetteEdge>& silhouette)
{
  std::vector<int> balance(geometry.getPositions().size(), 0);
  const std::vector<std::uint32_t> first = findFirstAtPosition(geometry);
  for (const SilhouetteEdge& edge : silhouette)
  {
    balance[first[edge.from]] += static_cast<int>(edge.multiplicity);
    balance[first[edge.to]] -= static_cast<int>(edge.multiplicity);
  }
  for (const int sum : balance)
  {
    EXPECT_EQ(sum, 0);
  }
}

} // namespace

TEST(Silhouette, ClosedMesh_AnyFacingBits_EveryVertexBalances)
{
  std::mt19937 random(1);
  for (const NamedMesh& mesh : makeClosedMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    for (int round = 0; round < 20; ++round)
    {
      const LightFacing facing = makeRandomFacing(geometry.getTriangles().size(), random, round % 2 == 1);
      expectBalanced(geometry, find(geometry, facing, Casting::LightFacing));
      expectBalanced(geometry, find(geometry, facing, Casting::EveryTriangle));
    }
  }
}

TEST(Silhouette, AnyMesh_AnyFacingBits_EveryTriangleBalances)
{
  std::mt19937 random(2);
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    for (int round = 0; round < 20; ++round)
    {
      const LightFacing facing = makeRandomFacing(geometry.getTriangles().size(), random, round % 2 == 1);
      expectBalanced(geometry, find(geometry, facing, Casting::EveryTriangle));
      expectBalanced(geometry, find(geometry, facing, Casting::LightFacing));
    }
  }
}

TEST(Silhouette, SoupVolume_SumOfPrismsEqualsMultiplicityVolume)
{
  std::mt19937 random(3);
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    const std::vector<std::uint32_t> first = findFirstAtPosition(geometry);
    const std::vector<glm::vec3>& p = geometry.getPositions();
    for (int round = 0; round < 20; ++round)
    {
      const glm::dvec4 light(randomPoint(random, 4.0), round % 2);
      EdgeBalance prisms;
      for (std::size_t t = 0; t < geometry.getTriangles().size(); ++t)
      {
        const auto& c = geometry.getTriangles()[t];
        // Turned to the light, whatever the mesh says about its orientation.
        prisms.addTriangle({first[c[0]], first[c[1]], first[c[2]]},
                           exactOrientation(p[c[0]], p[c[1]], p[c[2]], light));
      }
      EdgeBalance silhouette;
      for (const SilhouetteEdge& edge :
           find(geometry, computeFacing(geometry, light), Casting::EveryTriangle))
      {
        EXPECT_TRUE(edge.multiplicity == 1 || edge.multiplicity == 2);
        silhouette.add(first[edge.from], first[edge.to], static_cast<int>(edge.multiplicity));
      }
      EXPECT_EQ(prisms.get(), silhouette.get());
    }
  }
}

TEST(Silhouette, LightFacing_IsTheBoundaryOfTheTrianglesTowardsTheLight)
{
  std::mt19937 random(4);
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    const glm::dvec4 light(randomPoint(random, 4.0), 1.0);
    const LightFacing facing = computeFacing(geometry, light);
    EdgeBalance boundary;
    for (std::size_t t = 0; t < geometry.getTriangles().size(); ++t)
    {
      if (facing.towards.test(t))
      {
        boundary.addTriangle(geometry.getTriangles()[t], geometry.getReversed().test(t) ? -1 : 1);
      }
    }
    EdgeBalance silhouette;
    for (const SilhouetteEdge& edge : find(geometry, facing, Casting::LightFacing))
    {
      EXPECT_EQ(edge.multiplicity, 1u);
      silhouette.add(edge.from, edge.to);
    }
    EXPECT_EQ(boundary.get(), silhouette.get());
  }
}

TEST(Silhouette, LightInThePlanesOfManyTriangles_StaysClosed)
{
  const SEDGeometry geometry = build(makeTorus(1.0, 0.4, 64, 32));
  std::mt19937 random(5);
  for (int round = 0; round < 200; ++round)
  {
    const std::size_t t = random() % geometry.getTriangles().size();
    const auto corners = getCorners(geometry, t);
    const glm::dvec3 inPlane = corners[0] + 3.0 * (corners[1] - corners[0]) - 5.0 * (corners[2] - corners[0]);
    const LightFacing facing = computeFacing(geometry, glm::dvec4(inPlane, 1.0));
    expectBalanced(geometry, find(geometry, facing, Casting::LightFacing));
    expectBalanced(geometry, find(geometry, facing, Casting::EveryTriangle));
  }
}

TEST(Silhouette, Cube_HasSixEdgesSeenFromACorner)
{
  const SEDGeometry geometry = build(makeCube());
  const LightFacing facing = computeFacing(geometry, glm::dvec4(3, 4, 5, 1));
  EXPECT_EQ(find(geometry, facing, Casting::LightFacing).size(), 6u);
  EXPECT_EQ(facing.towards.countSet(), 6u);
}

} // namespace shadow::test
