// What the VETCollector tells of changes, and that it keeps up with them.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "CollectionLaws.h"
#include "SEDGeode.h"
#include "VETCollector.h"

using namespace shadow;
using namespace shadow::test;
using Change = VETCollector::Change;

namespace
{

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
  std::shared_ptr<const SEDGeometry> geometry = share(soup);
  holder->addChild(std::make_shared<SEDGeode>(geometry));
  root.addChild(holder);
  VETCollector collector;
  collector.collect(root);
  const VETCollection& collection = collector.getCollection();
  const std::uint64_t topology = collection.topologyRevision;
  std::size_t reordered = 0;
  for (int frame = 1; frame <= 20; ++frame)
  {
    const std::vector<std::array<std::uint32_t, 3>> before = collection.triangles;
    holder->clearChildren();
    SEDGeometryOptions options;
    options.previous = geometry.get();
    geometry = share(deform(soup, 0.3 * frame), options);
    holder->addChild(std::make_shared<SEDGeode>(geometry));
    ASSERT_EQ(collector.collect(root), Change::Positions) << "frame " << frame;
    EXPECT_EQ(collection.topologyRevision, topology);
    EXPECT_EQ(collection.ranges[0].positionRevision, topology);
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
