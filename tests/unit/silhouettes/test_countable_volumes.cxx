#include <gtest/gtest.h>

#include "BruteForceSilhouette.h"
#include "CountableVolumes.h"
#include "SEDGeometry.h"

namespace
{

using namespace shadow;

/// Squares in planes of constant z, all over each other.
SEDGeometry makeStack(std::uint32_t plates)
{
  TriangleSoup soup;
  for (std::uint32_t plate = 0; plate < plates; ++plate)
  {
    const double z = 0.01 * plate;
    const std::uint32_t first = 4 * plate;
    soup.points.insert(soup.points.end(), {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}});
    soup.triangles.push_back({first, first + 1, first + 2});
    soup.triangles.push_back({first, first + 2, first + 3});
  }
  std::string error;
  return *buildSEDGeometry(std::move(soup), {}, error);
}

std::vector<ShadowVolume> volumesOf(const SEDGeometry& geometry, const glm::dvec4& lightMC)
{
  const BruteForceSilhouette finder;
  return makeCountableVolumes(geometry, finder, computeFacing(geometry, lightMC), lightMC, {});
}

TEST(CountableVolumes, EveryPartCanBeCounted_AndTogetherTheyHoldEveryTriangle)
{
  for (const std::uint32_t plates : {100u, 255u, 256u, 300u, 2000u})
  {
    const SEDGeometry geometry = makeStack(plates);
    for (const glm::dvec4& light :
         {glm::dvec4(0, 0, 1, 0), glm::dvec4(0.1, 0.2, 50, 1), glm::dvec4(0, 0, 0, 1)})
    {
      const std::vector<ShadowVolume> volumes = volumesOf(geometry, light);
      std::size_t capTriangles = 0;
      for (const ShadowVolume& volume : volumes)
      {
        EXPECT_LE(volume.overlapBound, 255u);
        capTriangles += volume.lightCap.size() + volume.lightCapReversed.size();
      }
      const LightFacing facing = computeFacing(geometry, light);
      EXPECT_EQ(capTriangles, facing.towards.countSet() + facing.away.countSet());
      EXPECT_GE(volumes.size(), (plates + 254) / 255 - 1);
    }
  }
}

TEST(CountableVolumes, FewLayersStayOneVolume)
{
  EXPECT_EQ(volumesOf(makeStack(200), {0, 0, 1, 0}).size(), 1u);
}

} // namespace
