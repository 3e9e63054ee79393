// Masks of lines, compared with the truth.
#include <cstddef>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "OutlineError.h"
#include "TruthTestScenes.h"

namespace shadow::truth::test
{

namespace
{

constexpr int size = 64;
constexpr double half = 8.0;                      // world units
constexpr double pixelsPerUnit = size / 2 / half; // seen by lookingDown()

/// What a perfect drawing of a line would be.
std::vector<unsigned char> drawPerfectly(const OutlineTruth& truth, double lineWidth)
{
  std::vector<unsigned char> mask;
  for (int y = 0; y < truth.height(); ++y)
  {
    for (int x = 0; x < truth.width(); ++x)
    {
      mask.push_back(truth.distance(x, y) <= 0.5 * lineWidth ? 255 : 0);
    }
  }
  return mask;
}

} // namespace

TEST(OutlineError, PerfectDrawing_IsRightAtEveryWidth)
{
  Scene scene;
  addSphere(scene, {0.0, 0.0, 0.0}, 6.0, 24);
  scene = transformed(scene, oddRotation());
  const OutlineTruth truth(scene, lookingDown(size, half, 10.0));
  for (const double width : {1.0, 2.0, 4.0, 8.0})
  {
    const OutlineError error = compareOutline(truth, drawPerfectly(truth, width), width);
    EXPECT_GT(error.certain, 100u);
    EXPECT_EQ(error.missing, 0u);
    EXPECT_EQ(error.extra, 0u);
    EXPECT_EQ(error.spikes, 0u);
    EXPECT_EQ(error.completeness(), 1.0);
  }
}

TEST(OutlineError, GapsSpikesAndWideLines_AreFound)
{
  Scene scene;
  addFloor(scene, 5.0);
  const OutlineTruth truth(scene, lookingDown(size, half, 10.0));
  std::vector<unsigned char> mask = drawPerfectly(truth, 4.0);
  const int left = size / 2 - static_cast<int>(5.0 * pixelsPerUnit);
  mask[static_cast<std::size_t>(30) * size + left] = 0;
  mask[static_cast<std::size_t>(2) * size + 2] = 255;
  const OutlineError error = compareOutline(truth, mask, 4.0);
  EXPECT_EQ(error.missing, 1u);
  EXPECT_EQ(error.firstMissing, (std::vector<glm::ivec2>{{left, 30}}));
  EXPECT_EQ(error.extra, 1u);
  EXPECT_EQ(error.spikes, 1u);
  EXPECT_EQ(error.firstExtra, (std::vector<glm::ivec2>{{2, 2}}));
  EXPECT_LT(error.completeness(), 1.0);
  EXPECT_LT(error.correctness(), 1.0);

  // Pixel centres are half pixels off the lines; those 2.5 pixels off are 0.75 too far out.
  const OutlineError wide = compareOutline(truth, drawPerfectly(truth, 5.0), 3.5);
  EXPECT_GT(wide.extra, 100u);
  EXPECT_EQ(wide.spikes, 0u);
  EXPECT_THROW(compareOutline(truth, std::vector<unsigned char>(7), 4.0), std::invalid_argument);
}

} // namespace shadow::truth::test
