// computeFacing() against integer arithmetic that cannot round.

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "ExactOrientation.h"
#include "ShadowVolume.h"
#include "TestMeshes.h"
#include "VolumeOracle.h"

namespace shadow::test
{

namespace
{

using Wide = __int128;
using WidePoint = std::array<Wide, 3>;

WidePoint subtract(const WidePoint& left, const WidePoint& right)
{
  return {left[0] - right[0], left[1] - right[1], left[2] - right[2]};
}

/// Sign of dot(cross(b - a, c - a), arm).
int signOf(const WidePoint& a, const WidePoint& b, const WidePoint& c, const WidePoint& arm)
{
  const WidePoint u = subtract(b, a);
  const WidePoint v = subtract(c, a);
  const Wide value = (u[1] * v[2] - u[2] * v[1]) * arm[0] + (u[2] * v[0] - u[0] * v[2]) * arm[1] +
                     (u[0] * v[1] - u[1] * v[0]) * arm[2];
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// Coordinates that are whole numbers once multiplied by 2^bits.
WidePoint scale(const glm::dvec3& point, int bits)
{
  WidePoint result{};
  for (int axis = 0; axis < 3; ++axis)
  {
    result[axis] = static_cast<Wide>(std::ldexp(point[axis], bits));
  }
  return result;
}

int facingOf(const LightFacing& facing, std::size_t triangle)
{
  EXPECT_FALSE(facing.towards.test(triangle) && facing.away.test(triangle));
  return static_cast<int>(facing.towards.test(triangle)) - static_cast<int>(facing.away.test(triangle));
}

/// Random triangles with whole coordinates up to @p reach, centred on the origin.
TriangleSoup makeWholeSoup(std::uint32_t triangles, int reach, std::mt19937& random)
{
  std::uniform_int_distribution<int> coordinate(-reach, reach);
  TriangleSoup soup;
  // The first two triangles span the bounding box, so that the origin is zero.
  soup.points = {
      {-reach, -reach, -reach}, {reach, 0, 0}, {0, reach, 0}, {reach, reach, reach}, {0, 0, -reach}};
  soup.triangles = {{0, 1, 2}, {3, 4, 0}};
  for (std::uint32_t triangle = 0; triangle < triangles; ++triangle)
  {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (int corner = 0; corner < 3; ++corner)
    {
      soup.points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
    }
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

/// Compares every triangle with the integers. The light must be whole once multiplied by 2^bits.
void expectExact(const SEDGeometry& geometry, const glm::dvec4& light, int bits)
{
  ASSERT_EQ(geometry.getOrigin(), glm::dvec3(0.0));
  const LightFacing facing = computeFacing(geometry, light);
  for (std::size_t t = 0; t < geometry.getTriangles().size(); ++t)
  {
    // As oriented by the build, which may have turned triangles that happen to share an edge.
    const auto corners = getCorners(geometry, t);
    WidePoint arm = scale(glm::dvec3(light), bits);
    if (light.w != 0.0)
    {
      arm = subtract(arm, scale(corners[0], bits));
    }
    const WidePoint a = scale(corners[0], 0);
    const WidePoint b = scale(corners[1], 0);
    const WidePoint c = scale(corners[2], 0);
    ASSERT_EQ(facingOf(facing, t), signOf(a, b, c, arm)) << "triangle " << t;
  }
}

} // namespace

TEST(Facing, WholeCoordinates_MatchExactArithmetic)
{
  std::mt19937 random(1);
  for (const int reach : {3, 50, 1000, 1 << 20})
  {
    const TriangleSoup soup = makeWholeSoup(200, reach, random);
    const SEDGeometry geometry = build(soup);
    std::uniform_int_distribution<int> coordinate(-2 * reach, 2 * reach);
    for (int round = 0; round < 50; ++round)
    {
      const glm::dvec3 light(coordinate(random), coordinate(random), coordinate(random));
      expectExact(geometry, glm::dvec4(light, 1.0), 0);
      expectExact(geometry, glm::dvec4(light, 0.0), 0);
    }
  }
}

TEST(Facing, LightsInAPlaneAndAHairOffIt_MatchExactArithmetic)
{
  std::mt19937 random(2);
  const int reach = 1 << 18;
  const TriangleSoup soup = makeWholeSoup(300, reach, random);
  const SEDGeometry geometry = build(soup);
  for (std::size_t t = 0; t < 60; ++t)
  {
    const auto [a, b, c] = getCorners(geometry, t);
    const glm::dvec3 inPlane = a + 2.0 * (b - a) - 3.0 * (c - a);
    EXPECT_EQ(facingOf(computeFacing(geometry, glm::dvec4(inPlane, 1.0)), t), 0);
    EXPECT_EQ(facingOf(computeFacing(geometry, glm::dvec4(c - b, 0.0)), t), 0);
    for (const double hair : {0.0, 0x1p-30, -0x1p-30})
    {
      expectExact(geometry, glm::dvec4(inPlane + glm::dvec3(0, hair, 0), 1.0), 30);
    }
  }
}

TEST(Facing, RotatedTrianglesOfOnePlane_AgreeWithEachOther)
{
  std::mt19937 random(3);
  for (int round = 0; round < 200; ++round)
  {
    const TriangleSoup one = makeRandomSoup(1, round);
    TriangleSoup soup;
    for (int turn = 0; turn < 3; ++turn)
    {
      TriangleSoup turned = one;
      std::rotate(turned.triangles[0].begin(), turned.triangles[0].begin() + turn, turned.triangles[0].end());
      append(soup, turned);
    }
    const SEDGeometry geometry = build(soup);
    const std::vector<glm::vec3>& p = geometry.getPositions();
    const glm::dvec3 inPlane = 0.3 * glm::dvec3(p[0]) + 1.9 * glm::dvec3(p[1]) - 1.2 * glm::dvec3(p[2]);
    const LightFacing facing = computeFacing(geometry, glm::dvec4(inPlane, 1.0));
    // The repair may have turned one of them over.
    for (std::size_t t = 1; t < 3; ++t)
    {
      const bool turned = geometry.getReversed().test(t) != geometry.getReversed().test(0);
      EXPECT_EQ(facingOf(facing, t), (turned ? -1 : 1) * facingOf(facing, 0));
    }
  }
}

TEST(Facing, PlaneValuesBeyondTheirErrorBound_HaveTheExactSign)
{
  std::mt19937 random(4);
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    for (int round = 0; round < 50; ++round)
    {
      const glm::dvec4 light(randomPoint(random, 3.0), round % 2);
      const LightFacing facing = computeFacing(geometry, light);
      for (std::size_t t = 0; t < geometry.getTriangles().size(); ++t)
      {
        const auto& corners = geometry.getTriangles()[t];
        const std::vector<glm::vec3>& p = geometry.getPositions();
        const int exact = exactOrientation(p[corners[0]], p[corners[1]], p[corners[2]], light);
        EXPECT_EQ(facingOf(facing, t), geometry.getReversed().test(t) ? -exact : exact);
      }
    }
  }
}

TEST(Facing, LightAtAVertex_LeavesItsTrianglesUndecided)
{
  const SEDGeometry geometry = build(makeSphere(1.0, 12, 8));
  for (const std::size_t vertex : {0u, 5u, 40u})
  {
    const glm::dvec3 light(geometry.getPositions()[vertex]);
    const LightFacing facing = computeFacing(geometry, glm::dvec4(light, 1.0));
    for (std::size_t t = 0; t < geometry.getTriangles().size(); ++t)
    {
      const auto& corners = geometry.getTriangles()[t];
      const bool touches = std::find(corners.begin(), corners.end(), vertex) != corners.end();
      EXPECT_EQ(facingOf(facing, t) == 0, touches);
    }
  }
}

TEST(Facing, ExactOrientation_OfExtremeCoordinates)
{
  const glm::vec3 a(1e30f, 1e-30f, 0);
  const glm::vec3 b(-1e30f, 1e-30f, 1e-20f);
  const glm::vec3 c(3e-25f, 1e-30f, 1e20f);
  EXPECT_EQ(exactOrientation(a, b, c, glm::dvec4(0, 1e-30f, 0, 1)), 0);
  const int above = exactOrientation(a, b, c, glm::dvec4(5, 2e-30f, 7, 1));
  EXPECT_NE(above, 0);
  EXPECT_EQ(exactOrientation(a, b, c, glm::dvec4(5, -2e-30f, 7, 1)), -above);
  EXPECT_EQ(exactOrientation(a, c, b, glm::dvec4(5, 2e-30f, 7, 1)), -above);
  EXPECT_EQ(exactOrientation(a, b, c, glm::dvec4(0, 1, 0, 0)), above);
}

TEST(Facing, LightThatIsNotFinite_LightsNothing)
{
  const SEDGeometry geometry = build(makeCube());
  for (const double bad : {std::nan(""), HUGE_VAL})
  {
    const LightFacing facing = computeFacing(geometry, glm::dvec4(0, bad, 3, 1));
    EXPECT_EQ(facing.towards.countSet() + facing.away.countSet(), 0u);
  }
}

TEST(Facing, CountSet_CountsEveryWord)
{
  FacingBits bits(200);
  for (std::size_t t = 0; t < 200; t += 3)
  {
    bits.set(t);
  }
  EXPECT_EQ(bits.size(), 200u);
  EXPECT_EQ(bits.countSet(), 67u);
  bits.assign(130);
  EXPECT_EQ(bits.countSet(), 0u);
}

} // namespace shadow::test
