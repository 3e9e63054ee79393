// Laws of the polygons that HSD merges coplanar triangles into.

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "ExactOrientation.h"
#include "FlatRegionLaws.h"
#include "FlatRegions.h"
#include "HybridSilhouette.h"
#include "SilhouetteComparison.h"
#include "TestLights.h"
#include "TestMeshes.h"
#include "VolumeOracle.h"

namespace shadow::test
{

namespace
{

/// Squares of a chessboard of cells in the plane z = 0, two triangles each; those for which isHole is true
/// are left out.
template <class IsHole>
TriangleSoup makeBoard(std::uint32_t cells, IsHole&& isHole)
{
  TriangleSoup soup;
  for (std::uint32_t y = 0; y <= cells; ++y)
  {
    for (std::uint32_t x = 0; x <= cells; ++x)
    {
      soup.points.emplace_back(x, y, 0.0);
    }
  }
  for (std::uint32_t y = 0; y < cells; ++y)
  {
    for (std::uint32_t x = 0; x < cells; ++x)
    {
      if (!isHole(x, y))
      {
        const std::uint32_t a = y * (cells + 1) + x;
        soup.triangles.push_back({a, a + 1, a + cells + 2});
        soup.triangles.push_back({a, a + cells + 2, a + cells + 1});
      }
    }
  }
  return soup;
}

/// Number of border edges over all polygons.
std::size_t borderOf(const TriangleSoup& soup)
{
  return findFlatRegions(build(soup)).border.size();
}

} // namespace

TEST(FlatRegions, Cube_IsSixQuads)
{
  const SEDGeometry geometry = build(makeCube());
  const FlatRegions regions = findFlatRegions(geometry);
  EXPECT_EQ(regions.polygons.size(), 6u);
  EXPECT_EQ(regions.getRegionCount(), 6u);
  for (const FlatPolygon& polygon : regions.polygons)
  {
    EXPECT_EQ(polygon.triangleCount, 2u);
    EXPECT_EQ(polygon.borderEnd - polygon.borderBegin, 4u);
  }
}

TEST(FlatRegions, AnyMesh_BorderIsThatOfTheTriangles)
{
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    for (const double tolerance : {0.0, 1.0, 15.0, 60.0, 89.0})
    {
      SCOPED_TRACE(mesh.name + ", tolerance " + std::to_string(tolerance));
      const SEDGeometry geometry = build(mesh.soup);
      expectSound(geometry, findFlatRegions(geometry, tolerance));
    }
  }
}

TEST(FlatRegions, Board_IsOnePolygonWithItsHoles)
{
  const auto none = [](std::uint32_t, std::uint32_t) { return false; };
  const auto middle = [](std::uint32_t x, std::uint32_t y) { return x == 2 && y == 2; };
  const auto two = [](std::uint32_t x, std::uint32_t y) { return (x == 1 || x == 3) && y == 2; };
  const auto ring = [](std::uint32_t x, std::uint32_t y)
  { return x >= 1 && x <= 5 && y >= 1 && y <= 5 && !(x == 3 && y == 3); };
  EXPECT_EQ(borderOf(makeBoard(5, none)), 20u);
  EXPECT_EQ(borderOf(makeBoard(5, middle)), 24u);
  EXPECT_EQ(borderOf(makeBoard(5, two)), 28u);
  EXPECT_EQ(findFlatRegions(build(makeBoard(5, two))).getRegionCount(), 1u);
  // An island in a hole is a polygon of its own.
  const FlatRegions island = findFlatRegions(build(makeBoard(7, ring)));
  EXPECT_EQ(island.getRegionCount(), 2u);
  EXPECT_EQ(island.border.size(), 28u + 20u + 4u);
}

TEST(FlatRegions, RandomBoards_AreSound)
{
  std::mt19937 random(21);
  for (int round = 0; round < 200; ++round)
  {
    const std::uint32_t oneIn = 2 + random() % 5;
    const auto isHole = [&](std::uint32_t x, std::uint32_t y)
    { return (x != 0 || y != 0) && random() % oneIn == 0; };
    TriangleSoup soup = makeBoard(6, isHole);
    turnRandomly(soup, random());
    const SEDGeometry geometry = build(soup);
    const FlatRegions regions = findFlatRegions(geometry);
    expectSound(geometry, regions);
    EXPECT_EQ(regions.border.size(), geometry.getReport().borderEdges) << "all of it is one plane";
    EXPECT_EQ(regions.alone.countSet(), 0u);
  }
}

TEST(FlatRegions, AFold_IsNotFlat)
{
  TriangleSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 2, 0}};
  // Both in one plane, but folded back over their common edge.
  soup.triangles = {{0, 1, 2}, {1, 0, 3}};
  EXPECT_EQ(findFlatRegions(build(soup)).getRegionCount(), 2u);
}

TEST(FlatRegions, TriangleWithoutArea_StaysAlone)
{
  TriangleSoup soup;
  soup.points = {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 0}, {1, -1, 0}};
  soup.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 4, 3}, {3, 4, 1}};
  const SEDGeometry geometry = build(soup);
  ASSERT_EQ(geometry.getReport().zeroAreaTriangles, 1u);
  for (const double tolerance : {0.0, 30.0})
  {
    const FlatRegions regions = findFlatRegions(geometry, tolerance);
    EXPECT_EQ(regions.polygons.size(), 1u);
    EXPECT_EQ(regions.alone.countSet(), 2u) << "the upper triangle is cut off by the one without area";
  }
}

TEST(FlatRegions, NonManifoldEdges_EndRegions)
{
  // Two coplanar squares of which the common edge has a third triangle standing on it.
  TriangleSoup soup = makeBoard(2, [](std::uint32_t, std::uint32_t y) { return y == 1; });
  EXPECT_EQ(findFlatRegions(build(soup)).getRegionCount(), 1u);
  soup.points.emplace_back(1.0, 0.5, 1.0);
  soup.triangles.push_back({1, 4, static_cast<std::uint32_t>(soup.points.size() - 1)});
  const SEDGeometry geometry = build(soup);
  ASSERT_EQ(geometry.getReport().nonManifoldEdges, 1u);
  expectSound(geometry, findFlatRegions(geometry));
  // Which two of the three stay connected is the splitter's choice.
  EXPECT_GE(findFlatRegions(geometry).getRegionCount(), 2u);
  EXPECT_EQ(findFlatRegions(build(makeCubesSharingAnEdge())).getRegionCount(), 12u);
}

TEST(FlatRegions, ExactlyCoplanar_EveryLightSeesAPolygonFromOneSide)
{
  std::mt19937 random(22);
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    const FlatRegions regions = findFlatRegions(geometry);
    const std::vector<glm::vec3>& p = geometry.getPositions();
    for (int light = 0; light < 80; ++light)
    {
      const glm::dvec4 lightMC = makeLight(geometry, random, light);
      const auto signOf = [&](std::uint32_t t)
      {
        const auto& c = geometry.getTriangles()[t];
        return exactOrientation(p[c[0]], p[c[1]], p[c[2]], lightMC) *
               (geometry.getReversed().test(t) ? -1 : 1);
      };
      for (const FlatPolygon& polygon : regions.polygons)
      {
        for (const std::uint32_t t : trianglesOf(regions, polygon))
        {
          ASSERT_EQ(signOf(t), signOf(polygon.representative));
        }
      }
    }
  }
}

TEST(FlatRegions, Tilted_AnyPlaneIsMergedWhoseCoordinatesAreExact)
{
  // z = 3 x - 5 y + 7 on a grid of integers, and a rotation whose entries are not round.
  TriangleSoup soup = makeBoard(12, [](std::uint32_t, std::uint32_t) { return false; });
  TriangleSoup turned = soup;
  for (std::size_t point = 0; point < soup.points.size(); ++point)
  {
    glm::dvec3& q = soup.points[point];
    turned.points[point] = {0.6123 * q.x - 0.7906 * q.y, 0.7906 * q.x + 0.6123 * q.y, 0.377 * q.x};
    q.z = 3.0 * q.x - 5.0 * q.y + 7.0;
  }
  EXPECT_EQ(findFlatRegions(build(soup)).getRegionCount(), 1u);
  EXPECT_GT(findFlatRegions(build(turned)).getRegionCount(), 1u) << "rounding moved points off the plane";
  EXPECT_EQ(findFlatRegions(build(turned), 0.01).getRegionCount(), 1u);
}

TEST(FlatRegions, Tolerance_NormalsStayWithinItOfTheRepresentative)
{
  const SEDGeometry geometry = build(makeSphere(1.0, 40, 30));
  std::size_t before = findFlatRegions(geometry).getRegionCount();
  for (const double tolerance : {3.0, 10.0, 30.0})
  {
    const FlatRegions regions = findFlatRegions(geometry, tolerance);
    EXPECT_LT(regions.getRegionCount(), before);
    before = regions.getRegionCount();
    for (const FlatPolygon& polygon : regions.polygons)
    {
      const auto normalOf = [&geometry](std::uint32_t t)
      {
        const auto corners = getCorners(geometry, t);
        return glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
      };
      for (const std::uint32_t t : trianglesOf(regions, polygon))
      {
        const double cosine = glm::dot(normalOf(t), normalOf(polygon.representative));
        EXPECT_GE(cosine, std::cos(glm::radians(tolerance)) - 1e-9);
      }
    }
  }
}

TEST(FlatRegions, SimplifiedFacing_AgreesWithinEachPolygon)
{
  const SEDGeometry geometry = build(makeSphere(1.0, 24, 16));
  const HybridSilhouette finder(20.0);
  std::mt19937 random(23);
  bool changed = false;
  for (int light = 0; light < 80; ++light)
  {
    const LightFacing facing = computeFacing(geometry, makeLight(geometry, random, light));
    const LightFacing simplified = *finder.simplifyFacing(geometry, facing);
    const FlatRegions regions = findFlatRegions(geometry, 20.0);
    for (const FlatPolygon& polygon : regions.polygons)
    {
      const std::uint32_t r = polygon.representative;
      for (const std::uint32_t t : trianglesOf(regions, polygon))
      {
        const bool casts = facing.towards.test(t) || facing.away.test(t);
        const bool settled = facing.towards.test(r) || facing.away.test(r);
        ASSERT_EQ(simplified.towards.test(t),
                  settled ? casts && facing.towards.test(r) : facing.towards.test(t));
        ASSERT_EQ(simplified.away.test(t), settled ? casts && facing.away.test(r) : facing.away.test(t));
      }
    }
    changed = changed || simplified.towards.getWords() != facing.towards.getWords();
  }
  EXPECT_TRUE(changed) << "the tolerance did nothing";
  EXPECT_FALSE(HybridSilhouette().simplifyFacing(geometry, LightFacing()).has_value());
}

} // namespace shadow::test
