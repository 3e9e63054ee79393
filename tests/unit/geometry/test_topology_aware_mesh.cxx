// Valient's mesh: what a face knows of its neighbours.

#include <gtest/gtest.h>

#include "TestMeshes.h"
#include "TopologyAwareMesh.h"

namespace shadow::test
{

TEST(TopologyAwareMesh, AnyMesh_NeighboursAreMutual)
{
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    const TopologyAwareMesh tam(geometry);
    ASSERT_EQ(tam.countFaces(), geometry.getTriangles().size());
    std::size_t borders = 0;
    for (std::uint32_t face = 0; face < tam.countFaces(); ++face)
    {
      for (std::size_t edge = 0; edge < 3; ++edge)
      {
        const std::uint32_t neighbour = tam.getNeighbour(face, edge);
        if (neighbour == noTriangle)
        {
          ++borders;
          continue;
        }
        EXPECT_EQ(tam.getNeighbourNormal(face, edge), tam.getNormal(neighbour));
        EXPECT_TRUE(tam.getNeighbour(neighbour, 0) == face || tam.getNeighbour(neighbour, 1) == face ||
                    tam.getNeighbour(neighbour, 2) == face);
      }
    }
    EXPECT_EQ(borders, geometry.getReport().borderEdges);
  }
}

TEST(TopologyAwareMesh, NonManifoldEdge_PairsHaveNeighboursAndTheRestBorders)
{
  const auto countInner = [](const SEDGeometry& geometry)
  {
    const TopologyAwareMesh tam(geometry);
    std::size_t inner = 0;
    for (std::size_t face = 0; face < tam.countFaces(); ++face)
    {
      for (std::size_t edge = 0; edge < 3; ++edge)
      {
        inner += tam.getNeighbour(face, edge) != noTriangle ? 1 : 0;
      }
    }
    return inner;
  };
  // Four faces at one edge, of two solids: two pairs.
  const SEDGeometry cubes = build(makeCubesSharingAnEdge());
  EXPECT_EQ(cubes.getReport().nonManifoldEdges, 1u);
  EXPECT_EQ(countInner(cubes), 3 * cubes.getTriangles().size());
  // Pages that run through their edge the same way, of which no two are a pair.
  const SEDGeometry book = build(makeBook(3));
  EXPECT_EQ(book.getReport().nonManifoldEdges, 1u);
  EXPECT_EQ(countInner(book), 0u);
}

TEST(TopologyAwareMesh, OpenMesh_BordersHaveTheNegatedOwnNormal)
{
  const SEDGeometry geometry = build(makeOpenCylinder(12));
  const TopologyAwareMesh tam(geometry);
  std::size_t borders = 0;
  for (std::size_t face = 0; face < tam.countFaces(); ++face)
  {
    for (std::size_t edge = 0; edge < 3; ++edge)
    {
      if (tam.getNeighbour(face, edge) == noTriangle)
      {
        ++borders;
        EXPECT_EQ(tam.getNeighbourNormal(face, edge), -tam.getNormal(face));
      }
    }
  }
  EXPECT_EQ(borders, 24u);
}

} // namespace shadow::test
