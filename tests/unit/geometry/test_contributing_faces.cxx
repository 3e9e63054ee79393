// Which faces of a topology-aware mesh are left out: that none of them ever has a line, and that flat parts
// are.

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "ContributingFaces.h"
#include "MeshFiles.h"
#include "SilhouetteOracle.h"
#include "TestMeshes.h"
#include "TopologyAwareMesh.h"

namespace shadow::test
{

namespace
{

/// makeFlatSquare(), with a wall of height 1 on its front side, of triangles that stand on it.
TriangleSoup makeTray(std::uint32_t divisions)
{
  TriangleSoup soup = makeFlatSquare(divisions);
  for (std::uint32_t x = 0; x < divisions; ++x)
  {
    const auto upper = static_cast<std::uint32_t>(soup.points.size());
    soup.points.emplace_back(soup.points[x] + glm::dvec3(0.0, 0.0, 1.0));
    soup.points.emplace_back(soup.points[x + 1] + glm::dvec3(0.0, 0.0, 1.0));
    soup.triangles.push_back({x + 1, x, upper});
    soup.triangles.push_back({x + 1, upper, upper + 1});
  }
  return soup;
}

std::vector<bool> findDrawn(const SEDGeometry& geometry, const TopologyAwareMesh& mesh)
{
  std::vector<bool> drawn(mesh.countFaces(), false);
  std::uint32_t end = 0;
  const ContributingFaces contributing(geometry, mesh);
  for (const FaceRun& run : contributing.getRuns())
  {
    EXPECT_GE(run.first, end);
    EXPECT_GT(run.count, 0u);
    end = run.first + run.count;
    for (std::uint32_t face = run.first; face < end; ++face)
    {
      drawn.at(face) = true;
    }
  }
  return drawn;
}

std::size_t countLeftOut(const SEDGeometry& geometry)
{
  const TopologyAwareMesh mesh(geometry);
  return mesh.countFaces() - countFaces(ContributingFaces(geometry, mesh).getRuns());
}

/// Every line of an exact facing, each eye: it is no edge that is never one, and has a face that is drawn.
void expectNoLineLost(const SEDGeometry& geometry, int eyes)
{
  const TopologyAwareMesh mesh(geometry);
  const std::vector<bool> drawn = findDrawn(geometry, mesh);
  std::mt19937 random(11);
  for (int round = 0; round < eyes; ++round)
  {
    LightFacing facing =
        faceExactly(geometry, glm::dvec4(randomPoint(random, 4.0), round % 3 == 0 ? 0.0 : 1.0));
    mesh.completeFacing(facing);
    std::vector<FaceEdges> lines;
    mesh.findLines(geometry, facing, {true, true}, lines);
    for (const FaceEdges& line : lines)
    {
      for (std::size_t edge = 0; edge < 3; ++edge)
      {
        if ((line.edges >> edge & 1u) != 0)
        {
          const std::uint32_t other = mesh.getNeighbour(line.face, edge);
          EXPECT_TRUE(drawn[line.face] || (other != noTriangle && drawn[other]));
          EXPECT_TRUE(mesh.getFate(geometry, line.face, edge) != EdgeFate::Never ||
                      geometry.getPlane(line.face).normal == glm::dvec3(0.0));
        }
      }
    }
  }
}

} // namespace

TEST(ContributingFaces, AnyMesh_AnyEye_NoLineIsLost)
{
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    expectNoLineLost(build(mesh.soup), 10);
  }
  expectNoLineLost(build(makeFlatSquare(8)), 50);
  expectNoLineLost(build(makeTray(8)), 50);
}

TEST(ContributingFaces, FlatPart_WithoutItsRim)
{
  const SEDGeometry flat = build(makeFlatSquare(16));
  // Each edge of the rim has a triangle, and at two corners two edges have the same.
  EXPECT_EQ(countLeftOut(flat), flat.getTriangles().size() - (4 * 16 - 2));
  // A wall in place of a border leaves the same.
  EXPECT_EQ(countLeftOut(build(makeTray(16))), countLeftOut(flat));
}

TEST(ContributingFaces, BentBarely_NothingLeftOut)
{
  TriangleSoup soup = makeFlatSquare(4);
  for (glm::dvec3& point : soup.points)
  {
    point.z = 1e-6 * glm::dot(point, point);
  }
  EXPECT_EQ(countLeftOut(build(soup)), 0u);
}

TEST(ContributingFaces, FoldedOntoItself_KeepsTheFold)
{
  // Two triangles back to back: all three edges are always lines.
  TriangleSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  soup.triangles = {{0, 1, 2}, {0, 2, 1}};
  const SEDGeometry geometry = build(soup);
  EXPECT_EQ(countLeftOut(geometry), 0u);
}

TEST(ContributingFaces, FaceWithoutArea_KeptForItsBorderAlone)
{
  // Below the middle of an edge two triangles, or one and a border; a face without area closes the gap.
  TriangleSoup soup;
  soup.points = {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  soup.triangles = {{0, 2, 3}, {0, 1, 2}, {1, 0, 4}, {2, 1, 4}};
  for (const bool border : {false, true})
  {
    soup.triangles.resize(border ? 3 : 4);
    const SEDGeometry geometry = build(soup);
    ASSERT_EQ(geometry.getReport().zeroAreaTriangles, 1u);
    const TopologyAwareMesh mesh(geometry);
    const std::vector<bool> drawn = findDrawn(geometry, mesh);
    for (std::size_t face = 0; face < mesh.countFaces(); ++face)
    {
      const bool hasArea = geometry.getPlane(face).normal != glm::dvec3(0.0);
      EXPECT_EQ(drawn[face], hasArea || border) << face;
    }
  }
}

TEST(ContributingFaces, LongFrom_ThoseWithALongEdge)
{
  TriangleSoup soup = makeCube();
  append(soup, makeSphere(0.5, 24, 13, {5.0, 0.0, 0.0}));
  const SEDGeometry geometry = build(soup);
  const ContributingFaces contributing(geometry, TopologyAwareMesh(geometry));
  EXPECT_EQ(countFaces(contributing.findLongFrom(geometry, 0.0)), geometry.getTriangles().size());
  EXPECT_EQ(countFaces(contributing.findLongFrom(geometry, 1.0)), 12u);
  EXPECT_EQ(countFaces(contributing.findLongFrom(geometry, 3.0)), 0u);
}

} // namespace shadow::test
