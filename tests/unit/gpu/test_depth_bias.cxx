// How much farther sides of volumes are drawn, in the arithmetic of shaders/extrusion.glsl.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "ShadowPrograms.h"

using namespace shadow;

namespace
{

/// toClip(); rounded after each step, as a GL may or may not do.
float biasDepth(glm::vec2 bias, float z, float w)
{
  const volatile float scaled = z * bias.x;
  const volatile float shift = w * bias.y;
  return scaled + shift;
}

constexpr std::uint32_t mantissas = 1u << 23;

float withMantissa(std::uint32_t mantissa)
{
  return 1.0f + static_cast<float>(mantissa) / static_cast<float>(mantissas);
}

} // namespace

TEST(DepthBias, EndAtInfinity_StaysOnTheFarPlane)
{
  const glm::vec2 bias = depthBias(false, true);
  for (std::uint32_t mantissa = 0; mantissa < mantissas; ++mantissa)
  {
    const float w = withMantissa(mantissa);
    ASSERT_EQ(biasDepth(bias, w, w), w) << mantissa;
    ASSERT_EQ(std::fma(w, bias.x, w * bias.y), w) << mantissa;
  }
  EXPECT_EQ(biasDepth(depthBias(true, true), 0.0f, 3.0f), 0.0f) << "reversed depth is 0 there";
}

// Ordinary depth at up to three times the near distance; reversed depth anywhere.
TEST(DepthBias, Sides_AreFartherThanSurfaces)
{
  for (std::uint32_t mantissa = 0; mantissa < mantissas; mantissa += 1001)
  {
    const float w = 4.0f * withMantissa(mantissa);
    const float z = withMantissa(mantissa / 2);
    EXPECT_GT(biasDepth(depthBias(false, true), z, w), z);
    EXPECT_LT(biasDepth(depthBias(true, true), z, w), z);
    for (const float nearer : {1.0f, 1e-3f, 1e-6f})
    {
      EXPECT_LT(biasDepth(depthBias(true, true), nearer * z, w), nearer * z);
    }
    EXPECT_EQ(biasDepth(depthBias(false, false), z, w), z);
    EXPECT_EQ(biasDepth(depthBias(true, false), z, w), z);
  }
}
