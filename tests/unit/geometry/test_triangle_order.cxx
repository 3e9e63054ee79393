// Triangles stand in patches, and keep their places while a mesh deforms.

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "MeshFamilies.h"
#include "SilhouetteComparison.h"
#include "TestLights.h"

namespace shadow::test
{

namespace
{

/// Every point moved so that all stay apart, far enough to bring triangles into other patches.
TriangleSoup deform(TriangleSoup soup)
{
  for (glm::dvec3& point : soup.points)
  {
    point = {point.z + 0.3 * std::sin(2.0 * point.x), 3.0 * point.x, point.y + 0.2 * std::sin(3.0 * point.x)};
  }
  return soup;
}

std::array<std::uint32_t, 3> sorted(std::array<std::uint32_t, 3> corners)
{
  std::sort(corners.begin(), corners.end());
  return corners;
}

} // namespace

TEST(TriangleOrder, DeformedMesh_KeepsPlacesAndAnswersAreRight)
{
  const auto finders = makeAllFinders();
  std::mt19937 random(1);
  std::size_t sortedElsewhere = 0;
  for (const auto& meshes : {makeAllMeshes(), makeLargeMeshes()})
  {
    for (const NamedMesh& mesh : meshes)
    {
      SCOPED_TRACE(mesh.name);
      const SEDGeometry before = build(mesh.soup);
      const TriangleSoup deformed = deform(mesh.soup);
      SEDGeometryOptions options;
      options.previous = &before;
      const SEDGeometry after = build(deformed, options);
      ASSERT_EQ(after.getInputOrder(), before.getInputOrder());
      for (std::size_t t = 0; t < after.getTriangles().size(); ++t)
      {
        ASSERT_EQ(sorted(after.getTriangles()[t]), sorted(before.getTriangles()[t])) << t;
      }
      sortedElsewhere += build(deformed).getInputOrder() != before.getInputOrder() ? 1 : 0;
      for (int light = 0; light < 2 * lightKinds; ++light)
      {
        ASSERT_TRUE(expectSameAnswers(after, makeLight(after, random, light), finders)) << light;
      }
    }
  }
  EXPECT_GT(sortedElsewhere, 3u) << "the test is to meet this case";
}

TEST(TriangleOrder, OtherTrianglesThanBefore_AreSortedAnew)
{
  const TriangleSoup torus = makeTorus(1.0, 0.4, 32, 16);
  TriangleSoup shuffled = torus;
  std::shuffle(shuffled.triangles.begin(), shuffled.triangles.end(), std::mt19937(2));
  TriangleSoup smaller = torus;
  smaller.triangles.resize(torus.triangles.size() / 2);
  for (const TriangleSoup& other : {shuffled, smaller, makeTorus(1.0, 0.4, 16, 32)})
  {
    const SEDGeometry before = build(other);
    SEDGeometryOptions options;
    options.previous = &before;
    EXPECT_EQ(build(torus, options).getInputOrder(), build(torus).getInputOrder());
  }
}

} // namespace shadow::test
