// That what rounding to a rasteriser's grid and to single precision decides has no certain answer, and
// nothing more than that.
#include <gtest/gtest.h>

#include "DepthReach.h"
#include "SeenOutlines.h"
#include "ShadowingRange.h"

namespace shadow::fuzz
{

namespace
{

truth::LocalTriangle makeTriangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                                  double rounding = 0.0)
{
  return {a, b, c, rounding, 0, true, false, false};
}

/// A parallel view straight down, one pixel a unit, the window's corner at the origin; the near plane at
/// height 100, the far one at -100.
truth::View makeViewFromAbove()
{
  truth::View view;
  view.width = view.height = 100;
  view.clipFromWC = glm::dmat4(1.0);
  view.clipFromWC[0][0] = view.clipFromWC[1][1] = 2.0 / 100;
  view.clipFromWC[2][2] = -1.0 / 100;
  view.clipFromWC[3] = glm::dvec4(-1.0, -1.0, 0.0, 1.0);
  return view;
}

const glm::dvec4 above(0.0, 0.0, 1.0, 0.0);

bool passes(const std::vector<truth::LocalTriangle>& triangles, const glm::dvec2& at,
            const std::optional<truth::Hit>& hit = std::nullopt, const glm::dvec4& light = above)
{
  const truth::PixelRays rays(makeViewFromAbove(), glm::dvec3(0.0));
  return SeenOutlines(triangles, rays, light).pass(at, hit);
}

const truth::LocalTriangle left = makeTriangle({10, 50, 0}, {50, 10, 0}, {50, 90, 0});
const truth::LocalTriangle right = makeTriangle({90, 50, 0}, {50, 90, 0}, {50, 10, 0});

} // namespace

TEST(SeenOutlines, EdgeOfATriangle_PassesWithinTheGridOnly)
{
  for (const double side : {-1.0, 1.0})
  {
    EXPECT_TRUE(passes({left}, {50.0 + side / 300, 40.5}));
    EXPECT_FALSE(passes({left}, {50.0 + side / 200, 40.5}));
    EXPECT_FALSE(passes({left}, {50.0 + side / 300, 91.0})) << "beyond the edge's end";
  }
}

TEST(SeenOutlines, EdgeAcrossWhichTheSurfaceGoesOn_IsNoOutline)
{
  EXPECT_FALSE(passes({left, right}, {50.0, 40.5}));
  EXPECT_TRUE(passes({left, right}, {50.0, 90.0})) << "the end of the edge is a corner";
  EXPECT_TRUE(passes({left, right, right}, {50.0, 40.5})) << "three triangles at the edge";
  const truth::LocalTriangle folded = makeTriangle({40, 50, 5}, {50, 90, 0}, {50, 10, 0});
  EXPECT_TRUE(passes({left, folded}, {50.0, 40.5})) << "both on one side of the edge";
  const glm::dvec4 low(1.0, 0.0, 0.1, 0.0);
  const truth::LocalTriangle falling = makeTriangle({60, 50, -10}, {50, 90, 0}, {50, 10, 0});
  EXPECT_TRUE(passes({left, falling}, {50.0, 40.5}, std::nullopt, {-low.x, 0.0, low.z, 0.0}))
      << "the light sees them fold";
  EXPECT_FALSE(passes({left, falling}, {50.0, 40.5}, std::nullopt, above));
}

TEST(SeenOutlines, HiddenOutline_IsNone)
{
  const std::vector<truth::LocalTriangle> triangles = {
      left, makeTriangle({-90, -90, 9}, {290, -90, 9}, {0, 290, 9})};
  truth::Hit hit;
  hit.triangle = 1;
  hit.point = {50.0, 40.5, 9.0};
  EXPECT_FALSE(passes(triangles, {50.0, 40.5}, hit));
  hit.triangle = 0;
  hit.point.z = 0.0;
  EXPECT_TRUE(passes(triangles, {50.0, 40.5}, hit));
}

TEST(SeenOutlines, NeedleThinnerThanTheGrid_PassesWhatIsOnIt)
{
  const truth::LocalTriangle needle = makeTriangle({10, 50, 0}, {90, 50, 0}, {50, 50.001, 0});
  const truth::LocalTriangle over = makeTriangle({10, 50, 0}, {90, 50, 0}, {50, 90, 0});
  const truth::LocalTriangle below = makeTriangle({10, 50, 0}, {90, 50, 0}, {50, 10, 0});
  EXPECT_TRUE(passes({needle}, {30.5, 50.0005}));
  EXPECT_FALSE(passes({needle}, {30.5, 50.1}));
  EXPECT_TRUE(passes({needle, below}, {30.5, 50.0005})) << "though a triangle goes on from its long edge";
  EXPECT_FALSE(passes({over, below}, {30.5, 50.0005}));
}

TEST(SeenOutlines, VolumeThinnerThanTheGrid_PassesOnItsWayOnly)
{
  const truth::PixelRays rays(makeViewFromAbove(), glm::dvec3(0.0));
  const auto passThin = [&](double width, const glm::dvec2& at)
  {
    const std::vector<truth::LocalTriangle> triangles = {
        makeTriangle({20, 50, 0}, {20, 50 + width, 0}, {20, 50, 5})};
    return SeenOutlines(triangles, rays, {-1.0, 0.0, 0.0, 0.0}).passThinVolume(at);
  };
  EXPECT_TRUE(passThin(0.001, {70.5, 50.0005}));
  EXPECT_FALSE(passThin(0.001, {70.5, 50.01}));
  EXPECT_FALSE(passThin(0.1, {70.5, 50.0005}));
}

TEST(DepthReach, FlatSurface_IsAsFarAsItsCoordinates)
{
  const truth::PixelRays rays(makeViewFromAbove(), glm::dvec3(0.0));
  const auto reachOf = [&](const truth::LocalTriangle& triangle, const glm::dvec2& at)
  {
    const truth::Ray ray = rays.through(at.x, at.y);
    return getDepthReach(rays, {100.0, 100.0}, at, ray, triangle, truth::hitTriangle(triangle, ray).value());
  };
  const double flat = reachOf(left, {40.5, 50.5});
  EXPECT_LT(flat, 250.0);
  // Steep: at the window's right border the plane is 50 * 40 units deep.
  const truth::LocalTriangle steep = makeTriangle({49, 10, 0}, {49, 90, 0}, {51, 50, -80});
  EXPECT_GT(reachOf(steep, {49.5, 50.5}), 1900.0);
  // As deep as it is long, and a hundred times as long as it is high.
  const truth::LocalTriangle thin = makeTriangle({10, 50, 0}, {90, 50.4, -80}, {90, 50.6, -80});
  EXPECT_GT(reachOf(thin, {85.5, 50.472}), 80.0 * 100);
}

TEST(DepthReach, DeepParallelView_HalfItsRange)
{
  truth::View view = makeViewFromAbove();
  view.clipFromWC[2][2] = -1e-4;
  view.clipFromWC[3].z = 1e-2 - 1.0; // the near plane stays
  const truth::PixelRays rays(view, glm::dvec3(0.0));
  const truth::Ray ray = rays.through(40.0, 50.0);
  const truth::Hit hit = truth::hitTriangle(left, ray).value();
  EXPECT_NEAR(getDepthReach(rays, {100.0, 100.0}, {40.0, 50.0}, ray, left, hit), 1e4, 1.0);
}

// Rounding may turn the plane of a sliver any way, but not that of a triangle in whose plane the point is.
TEST(ShadowingRange, SliverAtTheLight_ShadowsAnythingSometimes)
{
  const glm::dvec4 light(0.0, 0.0, 2.0, 1.0);
  const auto find = [&](double width, double rounding, const glm::dvec3& point)
  {
    const truth::LocalTriangle triangle =
        makeTriangle({-1, -1, 2}, {1, 1, 2}, {width, -width, 2}, rounding);
    return findShadowing(triangle, point, 0.0, light, 1e-12);
  };
  for (const glm::dvec3& point : {glm::dvec3(3, 1, 0), glm::dvec3(-1, 3, 5), glm::dvec3(-2, -2, 1)})
  {
    EXPECT_EQ(find(1e-7, 1e-6, point), Shadowing::Sometimes);
    EXPECT_NE(find(1.0, 1e-12, point), Shadowing::Always);
  }
  EXPECT_EQ(find(1.0, 1e-12, {-9, -9, 2}), Shadowing::Never) << "in its plane";
  EXPECT_EQ(find(1e-7, 1e-6, {1, 1, 2}), Shadowing::Never) << "at its corner";
}

} // namespace shadow::fuzz
