// Laws of the VETCollector and of scene space, without any graphics.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <stdexcept>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "SEDGeode.h"
#include "SceneFrame.h"
#include "TestMeshes.h"
#include "VETCollector.h"

using namespace shadow;
using namespace shadow::test;
using Change = VETCollector::Change;

namespace
{

std::shared_ptr<const SEDGeometry> share(const TriangleSoup& soup)
{
  return std::make_shared<const SEDGeometry>(build(soup));
}

std::shared_ptr<Transform> place(const std::shared_ptr<Node>& child, const glm::dmat4& matrix)
{
  auto transform = std::make_shared<Transform>();
  transform->matrix = matrix;
  transform->addChild(child);
  return transform;
}

glm::dmat4 moved(double x, double y, double z)
{
  return glm::translate(glm::dmat4(1.0), glm::dvec3(x, y, z));
}

glm::dvec3 worldOf(const VETCollection& collection, std::uint32_t vertex)
{
  return (glm::dvec3(collection.high[vertex]) + glm::dvec3(collection.low[vertex])) * collection.frame.unit +
         collection.frame.originWC;
}

/// What the ranges say about the arrays holds, and the arrays are what the graph has.
void expectLaws(const VETCollection& collection, double tolerance)
{
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t edges = 0;
  for (const VETRange& range : collection.ranges)
  {
    const SEDGeometry& geometry = *range.geometry;
    ASSERT_EQ(range.firstVertex, vertices);
    ASSERT_EQ(range.firstTriangle, triangles);
    ASSERT_EQ(range.firstEdge, edges);
    EXPECT_EQ(collection.find(range.path), &range);
    for (std::size_t v = 0; v < range.countVertices(); ++v)
    {
      const glm::dvec3 model = geometry.getOrigin() + glm::dvec3(geometry.getPositions()[v]);
      const glm::dvec3 world(range.modelToWorld * glm::dvec4(model, 1.0));
      const auto vertex = static_cast<std::uint32_t>(range.firstVertex + v);
      ASSERT_LE(glm::distance(world, worldOf(collection, vertex)), tolerance);
      ASSERT_LE(glm::length(collection.low[vertex]), 1.1e-7f * glm::length(collection.high[vertex]));
    }
    for (std::size_t t = 0; t < range.countTriangles(); ++t)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        ASSERT_EQ(collection.triangles[triangles + t][corner], vertices + geometry.getTriangles()[t][corner]);
      }
      ASSERT_EQ(collection.reversed.test(triangles + t), geometry.getReversed().test(t) != range.mirrored);
    }
    vertices += range.countVertices();
    triangles += range.countTriangles();
    edges += range.countEdges();
  }
  EXPECT_EQ(collection.high.size(), vertices);
  EXPECT_EQ(collection.low.size(), vertices);
  EXPECT_EQ(collection.triangles.size(), triangles);
  EXPECT_EQ(collection.reversed.size(), triangles);
  EXPECT_EQ(collection.edges.size(), edges);
}

/// Every edge runs through its first triangle, oriented, as from -> to and through its second as to -> from.
void expectEdgesRunAsTriangles(const VETCollection& collection)
{
  const auto runs = [&collection](std::uint32_t triangle, std::uint32_t from, std::uint32_t to)
  {
    std::array<std::uint32_t, 3> corners = collection.triangles[triangle];
    if (collection.reversed.test(triangle))
    {
      std::swap(corners[1], corners[2]);
    }
    for (int corner = 0; corner < 3; ++corner)
    {
      if (corners[corner] == from && corners[(corner + 1) % 3] == to)
      {
        return true;
      }
    }
    return false;
  };
  for (const Edge& edge : collection.edges)
  {
    ASSERT_TRUE(runs(edge.triangles[0], edge.vertices[0], edge.vertices[1]));
    ASSERT_TRUE(edge.triangles[1] == noTriangle ||
                runs(edge.triangles[1], edge.vertices[1], edge.vertices[0]));
  }
}

/// Signed volume of the oriented triangles of a range, in the world.
double volumeOf(const VETCollection& collection, const VETRange& range)
{
  double volume = 0.0;
  for (std::size_t t = range.firstTriangle; t < range.firstTriangle + range.countTriangles(); ++t)
  {
    const auto& corners = collection.triangles[t];
    const glm::dvec3 a = worldOf(collection, corners[0]);
    const double six =
        glm::dot(a, glm::cross(worldOf(collection, corners[1]), worldOf(collection, corners[2])));
    volume += (collection.reversed.test(t) ? -six : six) / 6.0;
  }
  return volume;
}

/// The mesh with every point moved in a way that keeps all apart; some corners' order by x changes.
TriangleSoup deform(TriangleSoup soup, double phase)
{
  for (glm::dvec3& point : soup.points)
  {
    point += 0.2 * glm::dvec3(std::sin(3.0 * point.y + phase), std::cos(2.0 * point.z + phase), 0.0);
  }
  return soup;
}

} // namespace

TEST(VETCollector, SharedGeodeSeveralPaths_OneRangeEach)
{
  const auto geode = std::make_shared<SEDGeode>(share(makeTorus(1.0, 0.4, 12, 8)));
  const auto cube = std::make_shared<SEDGeode>(share(makeCube()));
  Group root;
  const auto middle = std::make_shared<Group>();
  middle->addChild(place(geode, moved(3.0, 0.0, 0.0)));
  middle->addChild(place(geode, glm::rotate(moved(-3.0, 1.0, 0.0), 0.7, glm::dvec3(0.0, 1.0, 1.0))));
  root.addChild(place(middle, moved(0.0, 5.0, 0.0)));
  root.addChild(cube);
  root.addChild(place(middle, glm::scale(glm::dmat4(1.0), glm::dvec3(0.5, 2.0, 1.0))));
  VETCollector collector;
  EXPECT_EQ(collector.collect(root), Change::Everything);
  EXPECT_EQ(collector.getCollection().ranges.size(), 5u);
  EXPECT_EQ(collector.getCollection().ranges[2].geometry, cube->getSharedGeometry())
      << "in order of the walk";
  expectLaws(collector.getCollection(), 1e-13);
  expectEdgesRunAsTriangles(collector.getCollection());
}

TEST(VETCollector, AnyMesh_EdgesRunAsTriangles)
{
  for (const double side : {1.0, -1.0})
  {
    Group root;
    for (const NamedMesh& mesh : makeAllMeshes())
    {
      root.addChild(place(std::make_shared<SEDGeode>(share(mesh.soup)),
                          glm::scale(glm::dmat4(1.0), glm::dvec3(2.0, side, 1.0))));
    }
    VETCollector collector;
    collector.collect(root);
    expectLaws(collector.getCollection(), 1e-12);
    expectEdgesRunAsTriangles(collector.getCollection());
  }
}

TEST(VETCollector, MirroredTransform_StillLooksOutwards)
{
  const auto geode = std::make_shared<SEDGeode>(share(makeTorus(1.0, 0.4, 24, 12)));
  Group root;
  root.addChild(geode);
  root.addChild(place(geode, glm::scale(moved(5.0, 0.0, 0.0), glm::dvec3(1.0, -1.0, 1.0))));
  root.addChild(place(geode, glm::scale(moved(0.0, 5.0, 0.0), glm::dvec3(-1.0, -1.0, 1.0))));
  VETCollector collector;
  collector.collect(root);
  const VETCollection& collection = collector.getCollection();
  const double volume = volumeOf(collection, collection.ranges[0]);
  EXPECT_GT(volume, 1.0);
  EXPECT_NEAR(volumeOf(collection, collection.ranges[1]), volume, 1e-5);
  EXPECT_NEAR(volumeOf(collection, collection.ranges[2]), volume, 1e-5);
  EXPECT_TRUE(collection.ranges[1].mirrored);
  EXPECT_FALSE(collection.ranges[2].mirrored);
}

TEST(VETCollector, FlattenedInvisibleAndDoubled_LeftOut)
{
  const auto geode = std::make_shared<SEDGeode>(share(makeCube()));
  Group root;
  const auto flat = place(geode, glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, 0.0, 1.0)));
  const auto hidden = place(geode, moved(1.0, 0.0, 0.0));
  hidden->visible = false;
  const auto quiet = place(geode, moved(2.0, 0.0, 0.0));
  quiet->casting = false;
  root.addChild(flat);
  root.addChild(hidden);
  root.addChild(quiet);
  root.addChild(quiet);
  VETCollector collector;
  collector.collect(root);
  ASSERT_EQ(collector.getCollection().ranges.size(), 1u);
  EXPECT_FALSE(collector.getCollection().ranges[0].casting);
  EXPECT_EQ(collector.getCollection().find({&root, flat.get(), geode.get()}), nullptr);
  EXPECT_NE(collector.getCollection().find({&root, quiet.get(), geode.get()}), nullptr);
  flat->matrix = moved(0.0, 4.0, 0.0);
  EXPECT_EQ(collector.collect(root), Change::Everything);
  EXPECT_EQ(collector.getCollection().ranges.size(), 2u);
}

TEST(VETCollector, EmptyGraph_EmptyCollection)
{
  Group root;
  VETCollector collector;
  EXPECT_EQ(collector.collect(root), Change::Everything);
  EXPECT_EQ(collector.collect(root), Change::Nothing);
  EXPECT_TRUE(collector.getCollection().ranges.empty());
  EXPECT_EQ(collector.getCollection().getMemorySize(), 0u);
}

TEST(VETCollector, UnchangedThenMovedThenMirrored_TellsWhat)
{
  const auto geode = std::make_shared<SEDGeode>(share(makeSphere(1.0, 12, 8)));
  const auto first = place(geode, moved(-2.0, 0.0, 0.0));
  const auto second = place(geode, moved(2.0, 0.0, 0.0));
  Group root;
  root.addChild(first);
  root.addChild(second);
  VETCollector collector;
  collector.collect(root);
  const VETCollection& collection = collector.getCollection();
  const std::uint64_t before = collection.topologyRevision;
  EXPECT_EQ(collector.collect(root), Change::Nothing);
  second->matrix = moved(2.0, 0.3, 0.0);
  EXPECT_EQ(collector.collect(root), Change::Positions);
  EXPECT_EQ(collection.topologyRevision, before);
  EXPECT_EQ(collection.ranges[0].positionRevision, before) << "has not moved";
  EXPECT_GT(collection.ranges[1].positionRevision, before);
  EXPECT_EQ(collection.ranges[1].orderRevision, before);
  expectLaws(collection, 1e-13);
  second->matrix = glm::scale(second->matrix, glm::dvec3(1.0, 1.0, -1.0));
  EXPECT_EQ(collector.collect(root), Change::Everything) << "edges and triangles turn";
  EXPECT_GT(collection.topologyRevision, before);
  expectLaws(collection, 1e-13);
  first->casting = false;
  EXPECT_EQ(collector.collect(root), Change::Nothing);
  EXPECT_FALSE(collection.ranges[0].casting) << "is kept up to date all the same";
}

TEST(VETCollector, MovedFarAway_NewFrameMovesEverything)
{
  const auto geode = std::make_shared<SEDGeode>(share(makeSphere(1.0, 12, 8)));
  const auto mover = place(geode, moved(2.0, 0.0, 0.0));
  Group root;
  root.addChild(geode);
  root.addChild(mover);
  VETCollector collector;
  collector.collect(root);
  const VETCollection& collection = collector.getCollection();
  const SceneFrame frame = collection.frame;
  mover->matrix = moved(1000.0, 0.0, 0.0);
  EXPECT_EQ(collector.collect(root), Change::Positions);
  EXPECT_FALSE(collection.frame == frame);
  EXPECT_GT(collection.ranges[0].positionRevision, collection.topologyRevision);
  expectLaws(collection, 1e-10);
  mover->matrix = moved(2.0, 0.0, 0.0);
  collector.collect(root);
  expectLaws(collection, 1e-13);
}

TEST(VETCollector, DeformedMeshBuiltAnew_OnlyPositionsAndOrder)
{
  const TriangleSoup soup = makeTorus(1.0, 0.4, 24, 12);
  Group root;
  root.addChild(std::make_shared<SEDGeode>(share(makeCube(glm::dvec3(0.0, -3.0, 0.0)))));
  const auto holder = std::make_shared<Group>();
  holder->addChild(std::make_shared<SEDGeode>(share(soup)));
  root.addChild(holder);
  VETCollector collector;
  collector.collect(root);
  const VETCollection& collection = collector.getCollection();
  const std::uint64_t topology = collection.topologyRevision;
  std::size_t reordered = 0;
  for (int frame = 1; frame <= 20; ++frame)
  {
    const std::vector<std::array<std::uint32_t, 3>> before = collection.triangles;
    const std::uint64_t order = collection.ranges[1].orderRevision;
    holder->clearChildren();
    holder->addChild(std::make_shared<SEDGeode>(share(deform(soup, 0.3 * frame))));
    ASSERT_EQ(collector.collect(root), Change::Positions) << "frame " << frame;
    EXPECT_EQ(collection.topologyRevision, topology);
    EXPECT_EQ(collection.ranges[0].positionRevision, topology);
    EXPECT_EQ(collection.ranges[1].orderRevision != order, before != collection.triangles);
    reordered += before != collection.triangles ? 1 : 0;
    expectLaws(collection, 1e-13);
    expectEdgesRunAsTriangles(collection);
  }
  EXPECT_GT(reordered, 0u) << "the test is to meet this case";
}

TEST(VETCollector, OtherMeshOfTheSameSize_Everything)
{
  TriangleSoup soup = makeTorus(1.0, 0.4, 24, 12);
  Group root;
  root.addChild(std::make_shared<SEDGeode>(share(soup)));
  VETCollector collector;
  collector.collect(root);
  std::swap(soup.triangles[3], soup.triangles[200]);
  root.clearChildren();
  root.addChild(std::make_shared<SEDGeode>(share(soup)));
  EXPECT_EQ(collector.collect(root), Change::Everything);
  expectLaws(collector.getCollection(), 1e-13);
}

TEST(VETCollector, MoreThanAnIntCounts_Throws)
{
  const auto geode = std::make_shared<SEDGeode>(share(makeSphere(1.0, 128, 128)));
  std::shared_ptr<Group> level = std::make_shared<Group>();
  level->addChild(geode);
  for (int depth = 0; depth < 4; ++depth)
  {
    auto above = std::make_shared<Group>();
    for (int i = 0; i < 16; ++i)
    {
      above->addChild(place(level, moved(i, depth, 0.0)));
    }
    level = above;
  }
  VETCollector collector;
  EXPECT_THROW(collector.collect(*level), std::length_error) << "65536 paths, 2 thousand million triangles";
  EXPECT_TRUE(collector.getCollection().ranges.empty());
  EXPECT_EQ(collector.collect(*geode), Change::Everything);
}

TEST(SceneFrame, SmallThingsFarFromTheOrigin_KeepTheirShape)
{
  // 10^7 away from the scene's origin, with details of 10^-2.
  const auto geode = std::make_shared<SEDGeode>(share(makeTorus(0.01, 0.004, 24, 12)));
  Group root;
  root.addChild(place(geode, moved(1e7, 1e7, -1e7)));
  root.addChild(place(geode, moved(-1e7, 0.0, 0.0)));
  VETCollector collector;
  collector.collect(root);
  // Doubles themselves are 2e-9 apart there.
  expectLaws(collector.getCollection(), 6e-8);
}

TEST(SceneFrame, IdentityTransform_RoundsNothing)
{
  const auto geometry = share(makeTorus(3.0, 1.1, 24, 12));
  Group root;
  root.addChild(std::make_shared<SEDGeode>(geometry));
  VETCollector collector;
  collector.collect(root);
  const VETCollection& collection = collector.getCollection();
  for (std::uint32_t vertex = 0; vertex < collection.high.size(); ++vertex)
  {
    EXPECT_EQ(worldOf(collection, vertex),
              geometry->getOrigin() + glm::dvec3(geometry->getPositions()[vertex]));
  }
}
