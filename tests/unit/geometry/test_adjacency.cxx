// Laws of buildSEDGeometry() on meshes that need no repair, and its errors.

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <tuple>
#include <utility>

#include <gtest/gtest.h>

#include "AllocationCounter.h"
#include "TestMeshes.h"
#include "VolumeOracle.h"

namespace shadow::test
{

namespace
{

std::string errorOf(const TriangleSoup& soup)
{
  std::string error;
  const bool built = buildSEDGeometry(soup, SEDGeometryOptions(), error).has_value();
  EXPECT_EQ(built, error.empty());
  EXPECT_EQ(error.find('\n'), std::string::npos);
  return error;
}

} // namespace

TEST(Adjacency, ClosedMeshes_EveryEdgeHasTwoTrianglesAndNothingIsChanged)
{
  for (const NamedMesh& mesh : makeClosedMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    EXPECT_TRUE(geometry.isClosed());
    EXPECT_EQ(geometry.getTriangles().size(), mesh.soup.triangles.size());
    EXPECT_EQ(2 * geometry.getEdges().size(), 3 * geometry.getTriangles().size());
    EXPECT_EQ(geometry.getPositions().size(), mesh.soup.points.size());
    EXPECT_EQ(geometry.getReport().flippedTriangles, 0u);
    EXPECT_EQ(geometry.getReport().splitVertices, 0u);
    EXPECT_EQ(geometry.getReport().nonManifoldEdges, 0u);
    EXPECT_EQ(geometry.getReport().degenerateTriangles, 0u);
  }
}

TEST(Adjacency, AnyMesh_EdgesRunAsTheirTrianglesAreWound)
{
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> sides;
    for (std::uint32_t t = 0; t < geometry.getTriangles().size(); ++t)
    {
      std::array<std::uint32_t, 3> corners = geometry.getTriangles()[t];
      if (geometry.getReversed().test(t))
      {
        std::swap(corners[1], corners[2]);
      }
      for (int k = 0; k < 3; ++k)
      {
        EXPECT_TRUE(sides.emplace(std::pair(corners[k], corners[(k + 1) % 3]), t).second);
      }
    }
    std::size_t borders = 0;
    for (const Edge& edge : geometry.getEdges())
    {
      const auto forward = sides.find({edge.vertices[0], edge.vertices[1]});
      ASSERT_NE(forward, sides.end());
      EXPECT_EQ(forward->second, edge.triangles[0]);
      sides.erase(forward);
      const auto backward = sides.find({edge.vertices[1], edge.vertices[0]});
      ASSERT_EQ(backward == sides.end(), edge.triangles[1] == noTriangle);
      if (backward != sides.end())
      {
        EXPECT_EQ(backward->second, edge.triangles[1]);
        sides.erase(backward);
      }
      borders += edge.triangles[1] == noTriangle ? 1 : 0;
    }
    EXPECT_TRUE(sides.empty());
    EXPECT_EQ(geometry.getReport().borderEdges, borders);
  }
}

TEST(Adjacency, AnyMesh_RasterOrderIsSortedAndPlanesFollowTheOrientation)
{
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    const auto key = [&](std::uint32_t vertex)
    {
      const glm::vec3& p = geometry.getPositions()[vertex];
      return std::tuple(p.x, p.y, p.z);
    };
    for (std::size_t t = 0; t < geometry.getTriangles().size(); ++t)
    {
      const std::array<std::uint32_t, 3>& raster = geometry.getTriangles()[t];
      EXPECT_LT(key(raster[0]), key(raster[1]));
      EXPECT_LT(key(raster[1]), key(raster[2]));
      const auto corners = getCorners(geometry, t);
      const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
      const TrianglePlane plane = geometry.getPlane(t);
      EXPECT_LE(glm::length(normal - plane.normal), 1e-12 * (1.0 + glm::length(normal)));
      for (const glm::dvec3& corner : corners)
      {
        EXPECT_NEAR(glm::dot(plane.normal, corner) + plane.offset, 0.0, 1e-12);
      }
    }
  }
}

TEST(Adjacency, UnsharedPoints_WeldIntoTheSharedMesh)
{
  const TriangleSoup torus = makeTorus(1.0, 0.4, 20, 10);
  const SEDGeometry geometry = build(makeUnshared(torus));
  EXPECT_TRUE(geometry.isClosed());
  EXPECT_EQ(geometry.getPositions().size(), torus.points.size());
}

TEST(Adjacency, NegativeZero_WeldsWithPositiveZero)
{
  TriangleSoup soup;
  soup.points = {{-1, 0.0, 0}, {1, -0.0, 0}, {0, 1, 0}, {-1, -0.0, 0}, {1, 0.0, -0.0}, {0, -1, 0}};
  soup.triangles = {{0, 1, 2}, {4, 3, 5}};
  const SEDGeometry geometry = build(soup);
  EXPECT_EQ(geometry.getPositions().size(), 4u);
  EXPECT_EQ(geometry.getEdges().size(), 5u);
}

TEST(Adjacency, Tolerance_ClosesGapsBelowItAndOnlyThose)
{
  TriangleSoup soup = makeUnshared(makeSphere(1.0, 16, 10));
  std::mt19937 random(3);
  for (glm::dvec3& point : soup.points)
  {
    point += randomPoint(random, 2e-5);
  }
  EXPECT_FALSE(build(soup).isClosed());
  const SEDGeometry welded = build(soup, {1e-3});
  EXPECT_TRUE(welded.isClosed());
  EXPECT_EQ(welded.getPositions().size(), makeSphere(1.0, 16, 10).points.size());
  EXPECT_EQ(welded.getReport().degenerateTriangles, 0u);
  EXPECT_FALSE(build(soup, {1e-9}).isClosed());
  EXPECT_TRUE(build(makeCube(), {std::numeric_limits<double>::denorm_min()}).isClosed());
}

TEST(Adjacency, Degenerate_TrianglesAreDroppedButCollinearOnesStay)
{
  TriangleSoup soup = makeCube();
  soup.triangles.push_back({0, 0, 1});
  soup.triangles.push_back({3, 5, 3});
  SEDGeometry geometry = build(soup);
  EXPECT_EQ(geometry.getReport().degenerateTriangles, 2u);
  EXPECT_EQ(geometry.getTriangles().size(), 12u);
  EXPECT_TRUE(geometry.isClosed());

  // A T-junction closed by a triangle without area: dropping it would open the mesh.
  TriangleSoup junction;
  junction.points = {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 2, 0}, {1, 1, 2}};
  junction.triangles = {{0, 3, 1}, {0, 1, 4}, {1, 3, 4}, {3, 0, 4}};
  EXPECT_TRUE(build(junction).isClosed());
  junction.triangles = {{0, 3, 2}, {2, 3, 1}, {0, 2, 1}, {0, 1, 4}, {1, 3, 4}, {3, 0, 4}};
  geometry = build(junction);
  EXPECT_EQ(geometry.getReport().zeroAreaTriangles, 1u);
  EXPECT_EQ(geometry.getReport().degenerateTriangles, 0u);
  EXPECT_TRUE(geometry.isClosed());
}

TEST(Adjacency, UnusableInput_IsRefusedWithOneLine)
{
  EXPECT_NE(errorOf(TriangleSoup()), "");
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
  {
    TriangleSoup used = makeCube();
    used.points[3].y = bad;
    EXPECT_NE(errorOf(used).find("point 3"), std::string::npos);
    TriangleSoup unused = makeCube();
    unused.points.emplace_back(0, 0, bad);
    EXPECT_NE(errorOf(unused).find("point 8"), std::string::npos);
  }
  TriangleSoup outOfRange = makeCube();
  outOfRange.triangles[4][1] = 8;
  EXPECT_NE(errorOf(outOfRange).find("triangle 4"), std::string::npos);
  TriangleSoup flat = makeCube();
  flat.triangles = {{0, 0, 0}, {1, 2, 1}};
  EXPECT_NE(errorOf(flat), "");
  TriangleSoup huge = makeCube(glm::dvec3(0.0), 1e39);
  EXPECT_NE(errorOf(huge), "");
  for (int axis = 0; axis < 3; ++axis)
  {
    TriangleSoup wide = makeCube();
    for (glm::dvec3& point : wide.points)
    {
      point[axis] *= 1e39;
    }
    EXPECT_NE(errorOf(wide), "") << "axis " << axis;
  }
}

TEST(Adjacency, LargeOffsetsAndScales_KeepTheShape)
{
  for (const double scale : {1e-30, 1e-6, 1e-2, 1.0, 1e9, 1e30})
  {
    SCOPED_TRACE(scale);
    const SEDGeometry geometry = build(makeCube(glm::dvec3(0.0), scale));
    EXPECT_TRUE(geometry.isClosed());
    EXPECT_EQ(geometry.getReport().zeroAreaTriangles, 0u);
    EXPECT_NEAR(geometry.getUpperBound().x / scale, 0.5, 1e-6);
  }
  const glm::dvec3 centre(1e7, -1e7, 1e7);
  const SEDGeometry geometry = build(makeSphere(1e-2, 16, 10, centre));
  EXPECT_TRUE(geometry.isClosed());
  EXPECT_NEAR(glm::length(geometry.getOrigin() - centre), 0.0, 1e-3);
  EXPECT_NEAR(geometry.getUpperBound().z, 1e-2, 1e-8);
}

// A light within rounding of a triangle's plane is on the side on which it is in the user's coordinates only if
// nothing was rounded: near 0, far from it, and where boxes lie beside it.
TEST(Adjacency, PointsInSinglePrecision_KeepEveryBit)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-3.0, 3.0);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  for (int mesh = 0; mesh < 300; ++mesh)
  {
    const double size = std::exp2(exponent(random));
    const glm::dvec3 centre =
        std::exp2(2.0 * exponent(random)) * glm::dvec3(share(random), share(random), share(random));
    TriangleSoup soup;
    for (std::uint32_t point = 0; point < 30; ++point)
    {
      soup.points.emplace_back(
          glm::vec3(centre + size * glm::dvec3(share(random), share(random), share(random))));
    }
    for (std::uint32_t first = 0; first < 30; first += 3)
    {
      soup.triangles.push_back({first, first + 1, first + 2});
    }
    std::vector<glm::dvec3> before = soup.points;
    const SEDGeometry geometry = build(std::move(soup));
    std::vector<glm::dvec3> after;
    for (const glm::vec3& position : geometry.getPositions())
    {
      after.push_back(geometry.getOrigin() + glm::dvec3(position));
    }
    const auto byPlace = [](const glm::dvec3& a, const glm::dvec3& b)
    { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
    std::sort(before.begin(), before.end(), byPlace);
    std::sort(after.begin(), after.end(), byPlace);
    ASSERT_EQ(before, after) << "mesh " << mesh;
  }
}

TEST(Adjacency, StrayPointThatNothingUses_CostsNoPrecision)
{
  TriangleSoup soup = makeSphere(1e-2, 16, 10);
  soup.points.emplace_back(1e12, 0, 0);
  const SEDGeometry geometry = build(soup);
  EXPECT_TRUE(geometry.isClosed());
  EXPECT_EQ(geometry.getPositions().size(), soup.points.size() - 1);
  EXPECT_LT(glm::length(geometry.getOrigin()), 1e-6);
}

TEST(Adjacency, Memory_StaysBelowItsBounds)
{
  for (const bool unshared : {false, true})
  {
    TriangleSoup soup = makeTorus(1.0, 0.4, 250, 100);
    soup = unshared ? makeUnshared(soup) : soup;
    const auto triangles = static_cast<double>(soup.triangles.size());
    const std::size_t soupBytes =
        soup.points.capacity() * sizeof(glm::dvec3) + 12 * soup.triangles.capacity();
    AllocationCounter::resetPeak();
    const std::size_t before = AllocationCounter::getCurrent() - soupBytes;
    std::string error;
    const auto geometry = buildSEDGeometry(std::move(soup), SEDGeometryOptions(), error);
    ASSERT_TRUE(geometry.has_value());
    EXPECT_LT(static_cast<double>(AllocationCounter::getPeak() - before) / triangles, 250.0);
    EXPECT_LT(static_cast<double>(AllocationCounter::getCurrent() - before) / triangles, 55.0);
    EXPECT_LT(static_cast<double>(geometry->getMemorySize()) / triangles, 45.0);
  }
}

} // namespace shadow::test
