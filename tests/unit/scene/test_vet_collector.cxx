// Laws of the VETCollector and of the positions it gives, without any graphics.

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
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
