#include <random>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "ScreenRectangle.h"

using namespace shadow;

namespace
{

View viewFrom(const glm::dvec3& eye, const glm::dvec3& focus, bool parallel)
{
  const glm::dmat4 clipFromView = parallel ? glm::ortho(-2.0, 2.0, -1.5, 1.5, 0.1, 50.0)
                                           : glm::perspective(0.8, 4.0 / 3.0, 0.1, 50.0);
  return makeView(clipFromView * glm::lookAt(eye, focus, glm::dvec3(0.0, 1.0, 0.0)), 640, 480);
}

BoxCorners boxAround(const glm::dvec3& centre, double half)
{
  BoxCorners corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    corners[i] = centre + half * glm::dvec3((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
  }
  return corners;
}

bool isWhole(const ScreenRectangle& rectangle, const View& view)
{
  return rectangle == wholeView(view);
}

} // namespace

TEST(ScreenRectangle, AnyBoxAndView_HoldsEveryPointOfTheBoxThatIsSeen)
{
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> place(-3.0, 3.0);
  std::uniform_real_distribution<double> within(-1.0, 1.0);
  std::size_t seen = 0;
  std::size_t bounded = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const View view = viewFrom({place(random), place(random), place(random)},
                               {place(random), place(random), place(random)}, i % 3 == 0);
    const glm::dvec3 centre(place(random), place(random), place(random));
    const double half = 0.1 + 0.3 * (1.0 + within(random));
    const ScreenRectangle cover = coverOf(boxAround(centre, half), view);
    bounded += isWhole(cover, view) ? 0 : 1;
    for (int j = 0; j < 50; ++j)
    {
      const glm::dvec3 point = centre + half * glm::dvec3(within(random), within(random), within(random));
      const glm::dvec4 clip = view.clipFromWC * glm::dvec4(point, 1.0);
      const glm::dvec2 pixel = (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(view.width, view.height);
      const bool inView = clip.w > 0.0 && glm::all(glm::greaterThanEqual(pixel, glm::dvec2(0.0))) &&
                          glm::all(glm::lessThan(pixel, glm::dvec2(view.width, view.height)));
      if (inView)
      {
        seen += 1;
        ASSERT_TRUE(glm::all(glm::greaterThanEqual(pixel, glm::dvec2(cover.lower)))) << i;
        ASSERT_TRUE(glm::all(glm::lessThan(pixel, glm::dvec2(cover.upper)))) << i;
      }
    }
  }
  EXPECT_GT(seen, 10000u);
  EXPECT_GT(bounded, 500u);
}

TEST(ScreenRectangle, SmallBox_NotMuchLargerThanItsPicture)
{
  const View view = viewFrom({0.0, 0.0, 5.0}, {0.0, 0.0, 0.0}, true);
  const ScreenRectangle cover = coverOf(boxAround(glm::dvec3(0.0), 0.1), view);
  // 0.2 of a view that is 4 wide and 3 high.
  EXPECT_NEAR(cover.upper.x - cover.lower.x, 0.2 / 4.0 * 640.0, 6.0);
  EXPECT_NEAR(cover.upper.y - cover.lower.y, 0.2 / 3.0 * 480.0, 6.0);
}

TEST(ScreenRectangle, BoxAroundOrBehindTheEye_WholeView)
{
  const View view = viewFrom({0.0, 0.0, 5.0}, {0.0, 0.0, 0.0}, false);
  EXPECT_TRUE(isWhole(coverOf(boxAround({0.0, 0.0, 5.0}, 0.5), view), view));
  EXPECT_TRUE(isWhole(coverOf(boxAround({0.3, 0.0, 4.6}, 0.4), view), view)) << "a corner in the eye's plane";
  EXPECT_TRUE(isWhole(coverOf(boxAround({0.0, 0.0, 4.8}, 0.9), view), view));
}

TEST(ScreenRectangle, NotFinite_WholeView)
{
  const View view = viewFrom({0.0, 0.0, 5.0}, {0.0, 0.0, 0.0}, false);
  BoxCorners corners = boxAround(glm::dvec3(0.0), 0.1);
  corners[3].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(isWhole(coverOf(corners, view), view));
  corners[3].x = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(isWhole(coverOf(corners, view), view));
}

TEST(ScreenRectangle, Joined_HoldsBoth)
{
  const ScreenRectangle one{{2, 3}, {5, 6}};
  const ScreenRectangle other{{4, 1}, {9, 4}};
  EXPECT_EQ(joined(one, other), (ScreenRectangle{{2, 1}, {9, 6}}));
  EXPECT_EQ(joined({}, one), one);
  EXPECT_EQ(joined(one, {}), one);
  EXPECT_TRUE(joined({}, {}).isEmpty());
}
