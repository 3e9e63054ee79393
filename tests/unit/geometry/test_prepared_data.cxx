// What methods prepare from a mesh lives as long as the mesh, and is prepared once.

#include <memory>
#include <utility>

#include <gtest/gtest.h>

#include "FlatRegions.h"
#include "PreparedData.h"
#include "SilhouetteComparison.h"
#include "TestMeshes.h"

namespace shadow::test
{

TEST(PreparedData, LivesAsLongAsTheGeometry)
{
  std::weak_ptr<const FlatRegions> watched;
  {
    SEDGeometry geometry = build(makeCube());
    const auto prepare = [](const SEDGeometry& from, double parameter, int& times)
    {
      return from.getPreparedData().get<FlatRegions>(parameter,
                                                     [&]
                                                     {
                                                       ++times;
                                                       return findFlatRegions(from, parameter);
                                                     });
    };
    const std::size_t before = geometry.getMemorySize();
    int times = 0;
    watched = prepare(geometry, 0.0, times);
    EXPECT_GT(geometry.getMemorySize(), before);
    const SEDGeometry moved = std::move(geometry);
    EXPECT_EQ(prepare(moved, 0.0, times), watched.lock());
    EXPECT_EQ(times, 1) << "prepared twice";
    EXPECT_NE(prepare(moved, 5.0, times), nullptr);
    EXPECT_EQ(times, 2);
    EXPECT_TRUE(watched.expired()) << "what belongs to another parameter is kept";
    watched = prepare(moved, 5.0, times);
    EXPECT_FALSE(watched.expired());
  }
  EXPECT_TRUE(watched.expired()) << "outlives its geometry";
}

TEST(PreparedData, ManyFindersForOneGeometry_PrepareOnce)
{
  const SEDGeometry geometry = build(makeTorus(1.0, 0.4, 32, 16));
  const LightFacing facing = computeFacing(geometry, glm::dvec4(3, 4, 5, 1));
  for (const SilhouetteMethod method : otherMethods())
  {
    makeSilhouetteFinder(method)->find(geometry, facing, Casting::LightFacing);
  }
  const std::size_t size = geometry.getMemorySize();
  for (int frame = 0; frame < 10; ++frame)
  {
    for (const SilhouetteMethod method : otherMethods())
    {
      makeSilhouetteFinder(method)->find(geometry, facing, Casting::EveryTriangle);
    }
  }
  EXPECT_EQ(geometry.getMemorySize(), size);
}

} // namespace shadow::test
