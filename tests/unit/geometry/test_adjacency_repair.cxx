// Laws of buildSEDGeometry() on meshes that have to be turned or cut.

#include <algorithm>

#include <gtest/gtest.h>

#include "TestMeshes.h"
#include "VolumeOracle.h"

namespace shadow::test
{

namespace
{

double signedVolume(const SEDGeometry& geometry)
{
  double volume = 0.0;
  for (std::size_t t = 0; t < geometry.getTriangles().size(); ++t)
  {
    const auto corners = getCorners(geometry, t);
    volume += glm::dot(corners[0], glm::cross(corners[1], corners[2])) / 6.0;
  }
  return volume;
}

} // namespace

TEST(Adjacency, RandomlyFlippedClosedMeshes_ComeOutClosedAndOutwards)
{
  for (const NamedMesh& mesh : makeClosedMeshes())
  {
    const double volume = signedVolume(build(mesh.soup));
    for (std::uint32_t seed = 0; seed < 10; ++seed)
    {
      SCOPED_TRACE(mesh.name);
      TriangleSoup soup = mesh.soup;
      turnRandomly(soup, seed);
      const SEDGeometry geometry = build(soup);
      EXPECT_TRUE(geometry.isClosed());
      EXPECT_EQ(geometry.getReport().splitVertices, 0u);
      EXPECT_GT(geometry.getReport().flippedTriangles, 0u);
      EXPECT_NEAR(signedVolume(geometry), volume, 1e-6 * volume);
    }
  }
}

TEST(Adjacency, InsideOutSphereAndCavity_LookOutwards)
{
  TriangleSoup soup = makeSphere(1.0, 16, 10);
  TriangleSoup cavity = makeSphere(0.5, 12, 8);
  const double sum = signedVolume(build(soup)) + signedVolume(build(cavity));
  turnInsideOut(cavity);
  append(soup, cavity);
  const SEDGeometry withCavity = build(soup);
  EXPECT_EQ(withCavity.getReport().flippedTriangles, cavity.triangles.size());
  EXPECT_NEAR(signedVolume(withCavity), sum, 1e-6);
  turnInsideOut(soup);
  const SEDGeometry insideOut = build(soup);
  EXPECT_EQ(insideOut.getReport().flippedTriangles, soup.triangles.size() - cavity.triangles.size());
  EXPECT_NEAR(signedVolume(insideOut), sum, 1e-6);
}

TEST(Adjacency, SmallInsideOutComponentFarAway_LooksOutwards)
{
  TriangleSoup soup = makeCube(glm::dvec3(-100, 0, 0));
  TriangleSoup small = makeCube(glm::dvec3(100, 0, 0), 1e-3);
  turnInsideOut(small);
  append(soup, small);
  EXPECT_EQ(build(soup).getReport().flippedTriangles, small.triangles.size());
}

TEST(Adjacency, OpenMesh_KeepsItsWinding)
{
  TriangleSoup soup = makeOpenCylinder(12);
  turnInsideOut(soup);
  const SEDGeometry geometry = build(soup);
  EXPECT_FALSE(geometry.isClosed());
  EXPECT_EQ(geometry.getReport().borderEdges, 24u);
  EXPECT_EQ(geometry.getReport().flippedTriangles, 0u);
}

TEST(Adjacency, FewFlippedTriangles_AreTheOnesTurned)
{
  TriangleSoup soup = makeOpenCylinder(12);
  std::swap(soup.triangles[0][1], soup.triangles[0][2]);
  const SEDGeometry geometry = build(soup);
  EXPECT_EQ(geometry.getReport().flippedTriangles, 1u);
  EXPECT_EQ(geometry.getReport().borderEdges, 24u);
  EXPECT_EQ(geometry.getReport().splitVertices, 0u);
}

TEST(Adjacency, MoebiusStrip_IsCutOnce)
{
  const SEDGeometry geometry = build(makeMoebius(15));
  EXPECT_EQ(geometry.getTriangles().size(), 30u);
  EXPECT_EQ(geometry.getReport().nonManifoldEdges, 0u);
  EXPECT_EQ(geometry.getReport().splitVertices, 2u);
  EXPECT_EQ(geometry.getReport().borderEdges, 32u);
}

TEST(Adjacency, BowTie_IsTwoClosedSolids)
{
  const SEDGeometry geometry = build(makeBowTie());
  EXPECT_TRUE(geometry.isClosed());
  EXPECT_EQ(geometry.getReport().splitVertices, 1u);
  EXPECT_EQ(geometry.getReport().nonManifoldEdges, 0u);
}

TEST(Adjacency, CubesSharingAnEdge_ComeApartClosed)
{
  for (std::uint32_t seed = 0; seed < 10; ++seed)
  {
    TriangleSoup soup = makeCubesSharingAnEdge();
    if (seed > 0)
    {
      turnRandomly(soup, seed);
    }
    const SEDGeometry geometry = build(soup);
    EXPECT_TRUE(geometry.isClosed());
    EXPECT_EQ(geometry.getReport().nonManifoldEdges, 1u);
    EXPECT_EQ(geometry.getReport().splitVertices, 2u);
    EXPECT_NEAR(signedVolume(geometry), 16.0, 1e-6);
  }
}

TEST(Adjacency, SolidPinchedInAnEdge_ComesApartClosed)
{
  // Four blocks in a ring that miss each other but for one edge: block 0 and block 3 touch in it.
  TriangleSoup soup;
  for (const glm::dvec3 centre : {glm::dvec3(0, 0, 0), glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 1),
                                  glm::dvec3(1, 1, 1), glm::dvec3(1, 1, 0)})
  {
    append(soup, makeCube(centre, 1.0));
  }
  // Faces between two blocks appear twice and cancel; remove them as a voxel mesher would.
  std::vector<std::array<std::uint32_t, 3>> outer;
  const auto key = [&soup](std::array<std::uint32_t, 3> triangle)
  {
    glm::dvec3 centre(0.0);
    for (const std::uint32_t corner : triangle)
    {
      centre += soup.points[corner];
    }
    return centre;
  };
  for (std::size_t t = 0; t < soup.triangles.size(); t += 2)
  {
    const glm::dvec3 face = key(soup.triangles[t]) + key(soup.triangles[t + 1]);
    std::size_t same = 0;
    for (std::size_t other = 0; other < soup.triangles.size(); other += 2)
    {
      same += glm::length(face - key(soup.triangles[other]) - key(soup.triangles[other + 1])) < 1e-9 ? 1 : 0;
    }
    if (same == 1)
    {
      outer.push_back(soup.triangles[t]);
      outer.push_back(soup.triangles[t + 1]);
    }
  }
  soup.triangles = outer;
  ASSERT_EQ(soup.triangles.size(), 44u);
  const SEDGeometry geometry = build(soup);
  EXPECT_EQ(geometry.getReport().nonManifoldEdges, 1u);
  EXPECT_TRUE(geometry.isClosed());
  EXPECT_NEAR(signedVolume(geometry), 5.0, 1e-6);
}

TEST(Adjacency, Book_SharesItsSpineBetweenTwoPages)
{
  for (std::uint32_t pages = 3; pages < 9; ++pages)
  {
    const SEDGeometry geometry = build(makeBook(pages));
    EXPECT_EQ(geometry.getTriangles().size(), pages);
    EXPECT_EQ(geometry.getReport().nonManifoldEdges, 1u);
    EXPECT_GT(geometry.getReport().splitVertices, 0u);
    for (const Edge& edge : geometry.getEdges())
    {
      EXPECT_NE(edge.vertices[0], edge.vertices[1]);
    }
  }
}

TEST(Adjacency, CrowdedEdge_WithManyTrianglesTakesNoQuadraticTime)
{
  const SEDGeometry geometry = build(makeBook(100000));
  EXPECT_EQ(geometry.getReport().nonManifoldEdges, 1u);
}

TEST(Adjacency, EdgeTwiceBetweenTheSameVertices_IsStillTaken)
{
  // Two tetrahedra glued along an edge through which a fan passes twice on its way around both ends.
  TriangleSoup soup;
  soup.points = {{0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  soup.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 0, 5}, {0, 2, 5}, {0, 4, 3}, {1, 3, 2}, {1, 5, 4}};
  turnRandomly(soup, 11);
  const SEDGeometry geometry = build(soup);
  EXPECT_EQ(geometry.getTriangles().size(), 8u);
}

TEST(Adjacency, DuplicateTriangles_LeaveTheFirstSheetWhole)
{
  TriangleSoup soup = makeSphere(1.0, 8, 6);
  const std::size_t triangles = soup.triangles.size();
  soup.triangles.push_back(soup.triangles[20]);
  const SEDGeometry geometry = build(soup);
  EXPECT_EQ(geometry.getTriangles().size(), triangles + 1);
  EXPECT_EQ(geometry.getReport().nonManifoldEdges, 3u);
  EXPECT_EQ(geometry.getReport().borderEdges, 3u);
}

TEST(Adjacency, RepairedMeshes_PrintNothing)
{
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    build(mesh.soup);
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST(Adjacency, RandomTrianglesOnFewVertices_AlwaysBuildAndKeepEveryTriangle)
{
  std::mt19937 random(17);
  for (int round = 0; round < 300; ++round)
  {
    TriangleSoup soup;
    for (int point = 0; point < 8; ++point)
    {
      soup.points.push_back(randomPoint(random, 1.0));
    }
    for (int triangle = 0; triangle < 30; ++triangle)
    {
      const std::uint32_t a = random() % 8;
      const std::uint32_t b = (a + 1 + random() % 7) % 8;
      std::uint32_t c = a;
      while (c == a || c == b)
      {
        c = random() % 8;
      }
      soup.triangles.push_back({a, b, c});
    }
    const SEDGeometry geometry = build(soup);
    ASSERT_EQ(geometry.getTriangles().size(), soup.triangles.size());
    for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    {
      glm::dvec3 expected(0.0);
      glm::dvec3 found(0.0);
      for (int k = 0; k < 3; ++k)
      {
        expected += soup.points[soup.triangles[geometry.getInputOrder()[t]][k]] - geometry.getOrigin();
        found += glm::dvec3(geometry.getPositions()[geometry.getTriangles()[t][k]]);
      }
      EXPECT_LT(glm::length(expected - found), 1e-5);
    }
  }
}

} // namespace shadow::test
