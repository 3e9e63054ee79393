#include "FlatRegionLaws.h"

#include <gtest/gtest.h>

#include "VolumeOracle.h"

namespace shadow::test
{

std::vector<std::uint32_t> trianglesOf(const FlatRegions& regions, const FlatPolygon& polygon)
{
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t index = polygon.wordsBegin; index < polygon.wordsEnd; ++index)
  {
    for (std::uint32_t bit = 0; bit < 64; ++bit)
    {
      if ((regions.words[index].mask >> bit) & 1u)
      {
        triangles.push_back(64 * regions.words[index].word + bit);
      }
    }
  }
  return triangles;
}

void expectSound(const SEDGeometry& geometry, const FlatRegions& regions)
{
  std::vector<int> met(geometry.getTriangles().size(), 0);
  for (std::uint32_t t = 0; t < met.size(); ++t)
  {
    met[t] += regions.alone.test(t) ? 1 : 0;
  }
  for (const FlatPolygon& polygon : regions.polygons)
  {
    const std::vector<std::uint32_t> triangles = trianglesOf(regions, polygon);
    EXPECT_EQ(triangles.size(), polygon.triangleCount);
    EXPECT_GE(triangles.size(), 2u);
    EdgeBalance inside;
    for (const std::uint32_t t : triangles)
    {
      ++met[t];
      inside.addTriangle(geometry.getTriangles()[t], geometry.getReversed().test(t) ? -1 : 1);
    }
    EdgeBalance border;
    for (std::uint32_t index = polygon.borderBegin; index < polygon.borderEnd; ++index)
    {
      border.add(regions.border[index][0], regions.border[index][1]);
    }
    EXPECT_EQ(border.get(), inside.get()) << "the border is not that of the triangles";
    EXPECT_EQ(border.get().size(), polygon.borderEnd - polygon.borderBegin) << "an inner edge was kept";
  }
  for (const int times : met)
  {
    EXPECT_EQ(times, 1) << "each triangle is in one region";
  }
}

} // namespace shadow::test
