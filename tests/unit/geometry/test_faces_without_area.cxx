// Faces without area: which face stands in for one, and what is known of its edges.

#include <bitset>
#include <numeric>

#include <gtest/gtest.h>

#include "FacesWithoutArea.h"
#include "SilhouetteFinder.h"
#include "TestMeshes.h"
#include "TopologyAwareMesh.h"

namespace shadow::test
{

namespace
{

/// Edges that are lines for an eye, without borders, by a facing of every edge and by one of some words
/// alone.
std::size_t countSilhouetteLines(const SEDGeometry& geometry, const glm::dvec3& eye)
{
  const TopologyAwareMesh mesh(geometry);
  std::vector<FaceEdges> every;
  for (const auto method : {SilhouetteMethod::BruteForce, SilhouetteMethod::Hierarchical})
  {
    LightFacing facing;
    makeSilhouetteFinder(method)->face(geometry, glm::dvec4(eye, 1.0), facing);
    mesh.completeFacing(facing);
    std::vector<FaceEdges> lines;
    mesh.findLines(geometry, facing, {true, false}, lines);
    if (method != SilhouetteMethod::BruteForce)
    {
      EXPECT_EQ(lines, every);
    }
    every = lines;
  }
  return std::accumulate(every.begin(), every.end(), std::size_t{0},
                         [](std::size_t edges, const FaceEdges& line)
                         { return edges + std::bitset<3>(line.edges).count(); });
}

/// Edges of faces that may be on the silhouette.
std::size_t countOpen(const SEDGeometry& geometry)
{
  const TopologyAwareMesh mesh(geometry);
  std::size_t open = 0;
  for (std::size_t side = 0; side < 3 * mesh.countFaces(); ++side)
  {
    open += mesh.getFate(geometry, side / 3, side % 3) == EdgeFate::Open ? 1 : 0;
  }
  return open;
}

} // namespace

TEST(FacesWithoutArea, Flat_NoLineButBorders)
{
  for (const auto& [name, soup] : makeFlatWithoutArea())
  {
    SCOPED_TRACE(name);
    const SEDGeometry geometry = build(soup);
    ASSERT_GT(geometry.getReport().zeroAreaTriangles, 0u);
    EXPECT_EQ(countOpen(geometry), 0u);
    EXPECT_TRUE(TopologyAwareMesh(geometry).findCreases(geometry, 0.0).empty());
    for (const double x : {-3.0, -0.01, 0.01, 3.0})
    {
      EXPECT_EQ(countSilhouetteLines(geometry, {x, 0.1, 0.2}), 0u) << x;
    }
  }
}

TEST(FacesWithoutArea, TwoAcrossTheirLongestEdge_FoldedThere_OneLineAlongTheFold)
{
  TriangleSoup soup = makeFlatWithoutArea().front().soup;
  // The lower half bends backwards.
  soup.points[5] = {-1.0, 0.0, 0.0};
  const SEDGeometry geometry = build(soup);
  const TopologyAwareMesh mesh(geometry);
  // Which half stands in for them does not matter, as long as it is the same one for both.
  ASSERT_EQ(geometry.getReport().zeroAreaTriangles, 2u);
  EXPECT_EQ(mesh.getNormal(2), mesh.getNormal(3));
  EXPECT_NE(mesh.getNormal(2), glm::vec3(0.0f));
  // In front of the upper half alone: along the fold, which that face without area that the other half
  // borders on has in two parts. Then behind both, and before both.
  EXPECT_EQ(countSilhouetteLines(geometry, {1.0, 0.0, 0.5}), 2u);
  EXPECT_EQ(countSilhouetteLines(geometry, {-1.0, 0.0, 0.5}), 0u);
  EXPECT_EQ(countSilhouetteLines(geometry, {1.0, 0.0, -0.5}), 0u);
}

TEST(FacesWithoutArea, NobodyStandsIn_NormalIsZeroAndNeighboursKnow)
{
  const SEDGeometry geometry = build(makeFlatWithoutArea().back().soup);
  const TopologyAwareMesh mesh(geometry);
  std::size_t without = 0;
  for (std::size_t face = 0; face < mesh.countFaces(); ++face)
  {
    without += mesh.getNormal(face) == glm::vec3(0.0f) ? 1 : 0;
    for (std::size_t edge = 0; edge < 3; ++edge)
    {
      const std::uint32_t neighbour = mesh.getNeighbour(face, edge);
      EXPECT_EQ(mesh.getFate(geometry, face, edge),
                neighbour == noTriangle ? EdgeFate::Border : EdgeFate::Never);
    }
  }
  EXPECT_EQ(without, 1u);
}

} // namespace shadow::test
