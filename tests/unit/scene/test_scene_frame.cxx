// Laws of scene space.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <glm/glm.hpp>

#include "SceneFrame.h"
#include "TestMeshes.h"

using namespace shadow;
using namespace shadow::test;

TEST(SceneFrame, Split_SumIsTheValueToTwoFloats)
{
  std::mt19937 random(2);
  for (const double reach : {1e-6, 1.0, 1e7})
  {
    for (int i = 0; i < 1000; ++i)
    {
      const glm::dvec3 value = randomPoint(random, reach);
      const SplitVector parts = split(value);
      for (int axis = 0; axis < 3; ++axis)
      {
        // One at a time: what this is to catch is a compiler that takes conversions for nothing.
        volatile float high = static_cast<float>(value[axis]);
        EXPECT_EQ(parts.high[axis], high);
        EXPECT_LE(std::abs(value[axis] - parts.high[axis] - parts.low[axis]),
                  0x1p-48 * std::abs(value[axis]));
      }
    }
  }
}

TEST(SceneFrame, Lights_KeepTheirPlace)
{
  const SceneFrame frame = SceneFrame::around({-3.0, -1.0, 5.0}, {4.0, 6.0, 9.0});
  std::mt19937 random(1);
  for (const double reach : {1e-3, 1.0, 1e3, 1e9, 1e30})
  {
    for (int i = 0; i < 100; ++i)
    {
      const Light light{0, glm::dvec4(randomPoint(random, reach), i % 2)};
      const auto scene = lightToScene(light, frame);
      ASSERT_TRUE(scene);
      const glm::dvec3 sum = glm::dvec3(scene->position.high) + glm::dvec3(scene->position.low);
      EXPECT_LE(glm::length(scene->position.high), 1.8f);
      if (light.positionWC.w == 0.0)
      {
        EXPECT_EQ(scene->w, 0.0f);
        EXPECT_LE(glm::length(glm::normalize(sum) - glm::normalize(glm::dvec3(light.positionWC))), 1e-14);
      }
      else
      {
        ASSERT_GT(scene->w, 0.0f);
        const glm::dvec3 world = sum / static_cast<double>(scene->w) * frame.unit + frame.originWC;
        EXPECT_LE(glm::distance(world, glm::dvec3(light.positionWC)), 1e-14 * (reach + 20.0));
      }
    }
  }
  EXPECT_FALSE(lightToScene(Light{0, {NAN, 0.0, 0.0, 1.0}}, frame));
  EXPECT_FALSE(lightToScene(Light{0, {0.0, INFINITY, 0.0, 0.0}}, frame));
}
