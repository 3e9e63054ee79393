// A mesh that is built with the one it was before it moved: what is taken over, and that it comes out as
// built from scratch.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "TestMeshes.h"

namespace shadow::test
{

namespace
{

/// Changes the raster order of many triangles.
TriangleSoup deform(TriangleSoup soup, double phase)
{
  for (glm::dvec3& point : soup.points)
  {
    point += 0.2 * glm::dvec3(std::sin(3.0 * point.y + phase), std::cos(2.0 * point.z + phase), 0.0);
  }
  return soup;
}

SEDGeometry buildAfter(const SEDGeometry& previous, const TriangleSoup& soup)
{
  SEDGeometryOptions options;
  options.previous = &previous;
  return build(soup, options);
}

template <class Value>
bool sameBytes(const std::vector<Value>& a, const std::vector<Value>& b)
{
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0);
}

bool operator==(const EdgeTable::Word& a, const EdgeTable::Word& b)
{
  return a.place == b.place && a.inner == b.inner && a.outer == b.outer;
}

bool same(const EdgeTable& a, const EdgeTable& b)
{
  return std::equal(a.words.begin(), a.words.end(), b.words.begin(), b.words.end(),
                    [](const EdgeTable::Word& one, const EdgeTable::Word& other) { return one == other; }) &&
         a.data == b.data && a.borders == b.borders && a.innerEdges == b.innerEdges &&
         a.outerEdges == b.outerEdges;
}

/// Bit for bit, all that a geometry holds; the cluster tree is made from these.
void expectSame(const SEDGeometry& a, const SEDGeometry& b)
{
  EXPECT_EQ(a.getOrigin(), b.getOrigin());
  EXPECT_TRUE(sameBytes(a.getPositions(), b.getPositions()));
  EXPECT_TRUE(a.getTriangles() == b.getTriangles());
  EXPECT_TRUE(a.getInputOrder() == b.getInputOrder());
  EXPECT_TRUE(a.getReversed().getWords() == b.getReversed().getWords());
  EXPECT_TRUE(sameBytes(a.getPlaneBlocks(), b.getPlaneBlocks()));
  EXPECT_EQ(a.getReach(), b.getReach());
  EXPECT_TRUE(same(a.getEdgeTable(), b.getEdgeTable()));
  EXPECT_EQ(a.getLowerBound(), b.getLowerBound());
  EXPECT_EQ(a.getUpperBound(), b.getUpperBound());
  EXPECT_EQ(a.getCommonPlane().has_value(), b.getCommonPlane().has_value());
  EXPECT_EQ(a.isClosed(), b.isClosed());
  EXPECT_EQ(a.getReport().borderEdges, b.getReport().borderEdges);
  EXPECT_EQ(a.getReport().zeroAreaTriangles, b.getReport().zeroAreaTriangles);
}

/// The same edges in the same order.
void expectSameEdges(const SEDGeometry& a, const SEDGeometry& b)
{
  const std::vector<Edge> edges = a.getEdges().toVector();
  const std::vector<Edge> others = b.getEdges().toVector();
  EXPECT_TRUE(std::equal(edges.begin(), edges.end(), others.begin(), others.end(),
                         [](const Edge& edge, const Edge& other)
                         { return edge.vertices == other.vertices && edge.triangles == other.triangles; }));
}

} // namespace

// The mesh in between has the same corners in the same order, but runs the other way: the order of triangles
// is taken over from it, and the edges are not.
TEST(MovedMesh, EdgesTakenOver_AsFromScratchBitForBit)
{
  std::size_t turned = 0;
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry before = build(mesh.soup);
    TriangleSoup otherWay = mesh.soup;
    turnInsideOut(otherWay);
    const SEDGeometry between = buildAfter(before, otherWay);
    ASSERT_EQ(between.getInputOrder(), before.getInputOrder());
    for (const double phase : {0.0, 1.0, 2.5})
    {
      const TriangleSoup deformed = deform(mesh.soup, phase);
      const SEDGeometry after = buildAfter(before, deformed);
      expectSame(after, buildAfter(between, deformed));
      turned += after.getRasterOrder() != before.getRasterOrder() ? 1 : 0;
    }
  }
  EXPECT_GT(turned, 10u) << "the test is to meet this case";
}

// Which triangles of a non-manifold edge are neighbours depends on where they lie, so that these may become
// others.
TEST(MovedMesh, SameTopologyUnlessAnythingButPositionsDiffers)
{
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry before = build(mesh.soup);
    const SEDGeometry after = buildAfter(before, deform(mesh.soup, 1.0));
    const SEDGeometry back = buildAfter(after, mesh.soup);
    if (before.getReport().nonManifoldEdges == 0)
    {
      EXPECT_TRUE(isSameMeshMoved(before, after));
      EXPECT_TRUE(isSameMeshMoved(before, back));
    }
    if (isSameMeshMoved(before, after))
    {
      expectSameEdges(before, after);
    }
    EXPECT_EQ(before.getTriangles() == after.getTriangles(),
              before.getRasterOrder() == after.getRasterOrder());
    EXPECT_FALSE(isSameMeshMoved(before, build(mesh.soup))) << "it was not built with the other";

    if (mesh.soup.triangles.size() > 1)
    {
      TriangleSoup fewer = mesh.soup;
      fewer.triangles.pop_back();
      EXPECT_FALSE(isSameMeshMoved(before, buildAfter(before, fewer)));
    }
  }
}

TEST(MovedMesh, PointsThatMeet_AnotherMesh)
{
  const TriangleSoup soup = makeSphere(1.0, 12, 8);
  TriangleSoup welded = soup;
  welded.points[welded.triangles[40][1]] = welded.points[welded.triangles[40][0]];
  const SEDGeometry before = build(soup);
  const SEDGeometry after = buildAfter(before, welded);
  EXPECT_FALSE(isSameMeshMoved(before, after));
  expectSame(after, build(welded));
  EXPECT_FALSE(isSameMeshMoved(after, buildAfter(after, soup))) << "and apart again";
}

TEST(MovedMesh, OtherPairOfPointsThatMeets_AnotherMesh)
{
  TriangleSoup soup = makeUnshared(makeSphere(1.0, 12, 8));
  const SEDGeometry before = build(soup);
  // As many vertices as before: one pair of points parts, another one meets.
  std::swap(soup.points[soup.triangles[10][0]], soup.points[soup.triangles[50][0]]);
  const SEDGeometry after = buildAfter(before, soup);
  EXPECT_FALSE(isSameMeshMoved(before, after));
  expectSame(after, build(soup));
}

TEST(MovedMesh, TurnedInsideOutByMoving_AnotherMeshThatIsRight)
{
  const TriangleSoup soup = makeTorus(1.0, 0.4, 24, 12);
  TriangleSoup mirrored = soup;
  for (glm::dvec3& point : mirrored.points)
  {
    point.x = -point.x;
  }
  const SEDGeometry before = build(soup);
  const SEDGeometry after = buildAfter(before, mirrored);
  EXPECT_FALSE(isSameMeshMoved(before, after)) << "its triangles are oriented the other way";
  EXPECT_EQ(after.getReport().flippedTriangles, after.getTriangles().size());
  TriangleSoup otherWay = soup;
  turnInsideOut(otherWay);
  expectSame(after, buildAfter(buildAfter(before, otherWay), mirrored));
}

// Face culling goes by the input's winding, all else by the orientation.
TEST(MovedMesh, InputWoundOtherwise_SameTopologyInAnotherOrder)
{
  const TriangleSoup soup = makeTorus(1.0, 0.4, 24, 12);
  TriangleSoup scrambled = soup;
  turnRandomly(scrambled, 1);
  const SEDGeometry before = build(scrambled);
  std::size_t met = 0;
  for (std::uint32_t seed = 2; seed < 12; ++seed)
  {
    TriangleSoup otherwise = soup;
    turnRandomly(otherwise, seed);
    const SEDGeometry after = buildAfter(before, otherwise);
    EXPECT_NE(before.getInputReversed().getWords(), after.getInputReversed().getWords());
    EXPECT_NE(before.getRasterOrder(), after.getRasterOrder());
    met += isSameMeshMoved(before, after) ? 1 : 0;
  }
  EXPECT_GT(met, 0u) << "the test is to meet this case";
}

} // namespace shadow::test
