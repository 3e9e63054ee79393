// The truth of outlines, held against scenes whose outline is known.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "OutlineTruth.h"
#include "TruthTestScenes.h"

namespace shadow::truth::test
{

namespace
{

constexpr int size = 64;
constexpr double half = 8.0;                      // world units
constexpr double pixelsPerUnit = size / 2 / half; // seen by lookingDown()

/// Four sides, top and bottom of a box between heights 0 and 2; its top is @p topHalf wide, its bottom 4.
void addFrustum(Scene& scene, double topHalf)
{
  const auto corner = [topHalf](int i, bool top)
  {
    constexpr std::array<std::array<double, 2>, 4> signs = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    const double reach = top ? topHalf : 4.0;
    return glm::dvec3(signs[i][0] * reach, signs[i][1] * reach, top ? 2.0 : 0.0);
  };
  const auto quad =
      [&scene](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d)
  {
    scene.triangles.push_back(makeTriangle(a, b, c));
    scene.triangles.push_back(makeTriangle(a, c, d));
  };
  quad(corner(0, true), corner(1, true), corner(2, true), corner(3, true));
  quad(corner(3, false), corner(2, false), corner(1, false), corner(0, false));
  for (int i = 0; i < 4; ++i)
  {
    const int next = (i + 1) % 4;
    quad(corner(i, false), corner(next, false), corner(next, true), corner(i, true));
  }
}

/// Distance from a point to the rim of an upright rectangle around the middle of the view, in pixels.
double distanceToRectangle(const glm::dvec2& point, const glm::dvec2& halfSize)
{
  const glm::dvec2 outside = glm::abs(point - 0.5 * size) - halfSize;
  const glm::dvec2 beyond = glm::max(outside, 0.0);
  return std::abs(glm::length(beyond) + std::min(std::max(outside.x, outside.y), 0.0));
}

/// Expects distances to the rim of a rectangle, all of it certain, as far as they are known.
void expectRectangle(const OutlineTruth& truth, const glm::dvec2& halfSize)
{
  for (int y = 0; y < size; ++y)
  {
    for (int x = 0; x < size; ++x)
    {
      const double distance = distanceToRectangle({x + 0.5, y + 0.5}, halfSize);
      if (distance < 8.0)
      {
        ASSERT_NEAR(truth.distance(x, y), distance, 1e-6) << x << ", " << y;
        ASSERT_NEAR(truth.certainDistance(x, y), distance, 1e-6) << x << ", " << y;
      }
    }
  }
}

double lengthOf(const std::vector<OutlinePiece>& pieces, bool certain)
{
  double length = 0.0;
  for (const OutlinePiece& piece : pieces)
  {
    length += piece.certain == certain ? glm::distance(piece.from, piece.to) : 0.0;
  }
  return length;
}

} // namespace

TEST(OutlineTruth, Frustum_SeenFromAbove_OutlineIsItsBottom)
{
  Scene scene;
  addFrustum(scene, 2.0);
  expectRectangle(OutlineTruth(scene, lookingDown(size, half, 10.0)), glm::dvec2(4.0 * pixelsPerUnit));
}

TEST(OutlineTruth, Frustum_UpsideDown_OutlineIsItsTop)
{
  Scene scene;
  addFrustum(scene, 6.0);
  expectRectangle(OutlineTruth(scene, lookingDown(size, half, 10.0)), glm::dvec2(6.0 * pixelsPerUnit));
}

TEST(OutlineTruth, Frustum_WindingMixed_IsTheSame)
{
  Scene scene;
  addFrustum(scene, 2.0);
  for (std::size_t i = 0; i < scene.triangles.size(); i += 3)
  {
    std::swap(scene.triangles[i].b, scene.triangles[i].c);
  }
  expectRectangle(OutlineTruth(scene, lookingDown(size, half, 10.0)), glm::dvec2(4.0 * pixelsPerUnit));
}

TEST(OutlineTruth, Cube_InPerspective_OutlineIsItsNearFace)
{
  Scene scene;
  addFrustum(scene, 4.0);
  const View view = lookingAt({0.0, 0.0, 20.0}, {0.0, 0.0, 0.0}, size, size, 60.0);
  const double scale = 0.5 * size / std::tan(glm::radians(30.0)) / 18.0;
  expectRectangle(OutlineTruth(scene, view), glm::dvec2(4.0 * scale));
}

TEST(OutlineTruth, Cube_EyeInTheSamePlanesFarOff_SameOutlineFarFromTheOrigin)
{
  const glm::dvec3 far(1e7, -2e7, 3e6);
  Scene scene;
  addFrustum(scene, 4.0);
  scene = transformed(scene, glm::translate(glm::dmat4(1.0), far));
  const View view = lookingAt(far + glm::dvec3(0.0, 0.0, 20.0), far, size, size, 60.0);
  const OutlineTruth truth(scene, view);
  const double expected = 4.0 * 0.5 * size / std::tan(glm::radians(30.0)) / 18.0;
  EXPECT_NEAR(lengthOf(truth.pieces(), true), 8.0 * expected, 1.0);
}

TEST(OutlineTruth, Sphere_SeenFromAfar_OutlineIsACircle)
{
  Scene scene;
  addSphere(scene, {0.0, 0.0, 0.0}, 6.0, 96);
  scene = transformed(scene, oddRotation());
  const OutlineTruth truth(scene, lookingDown(size, half, 10.0));
  const double radius = 6.0 * pixelsPerUnit;
  for (const OutlinePiece& piece : truth.pieces())
  {
    EXPECT_NEAR(glm::distance(piece.from, glm::dvec2(0.5 * size)), radius, 0.1);
  }
  for (int degrees = 0; degrees < 360; degrees += 5)
  {
    const glm::dvec2 way(std::cos(glm::radians(1.0 * degrees)), std::sin(glm::radians(1.0 * degrees)));
    const glm::ivec2 pixel(glm::floor(0.5 * size + radius * way));
    EXPECT_LT(truth.certainDistance(pixel.x, pixel.y), 0.9) << degrees;
  }
}

TEST(OutlineTruth, OpenSheet_HasItsBorderAndNoDiagonal)
{
  Scene scene;
  addFloor(scene, 5.0);
  expectRectangle(OutlineTruth(scene, lookingDown(size, half, 10.0)), glm::dvec2(5.0 * pixelsPerUnit));
}

TEST(OutlineTruth, SheetStoredTwice_IsTheSheetStoredOnce)
{
  for (const int copies : {1, 2})
  {
    for (const bool turned : {false, true})
    {
      Scene scene;
      addFloor(scene, 5.0);
      // All of it, and one half of it.
      for (int triangle = 0; triangle < 2 * copies - 1; ++triangle)
      {
        const Triangle& one = scene.triangles[triangle % 2];
        scene.triangles.push_back(turned ? makeTriangle(one.c, one.b, one.a)
                                         : makeTriangle(one.b, one.c, one.a));
      }
      expectRectangle(OutlineTruth(scene, lookingDown(size, half, 10.0)), glm::dvec2(5.0 * pixelsPerUnit));
    }
  }
}

TEST(OutlineTruth, SheetUnderASheet_ShowsWhatSticksOut)
{
  Scene scene;
  addFloor(scene, 5.0);
  // Covers all x above 0, far beyond the view.
  addQuad(scene, {0.0, -100.0, 1.0}, {100.0, 0.0, 0.0}, {0.0, 200.0, 0.0});
  const OutlineTruth truth(scene, lookingDown(size, half, 10.0));
  // The sheet's left half: a side of 10 and two of 5; and the upper one's left border across the view of 16,
  // followed a little way outside the view, where nothing is certain.
  EXPECT_NEAR(lengthOf(truth.pieces(), true), (10.0 + 2 * 5.0 + 16.0) * pixelsPerUnit, 2.0);
  EXPECT_NEAR(lengthOf(truth.pieces(), false), 2.0 * 8.0, 2.0);
  // The covered right side, and the end of a line under the upper sheet.
  const int right = size / 2 + static_cast<int>(5.0 * pixelsPerUnit);
  EXPECT_EQ(truth.line(right, size / 2, 8.0), OutlineTruth::Line::No);
  const int top = size / 2 + static_cast<int>(5.0 * pixelsPerUnit);
  EXPECT_EQ(truth.line(size / 2 - 6, top, 2.0), OutlineTruth::Line::Yes);
  EXPECT_EQ(truth.line(size / 2 + 6, top, 2.0), OutlineTruth::Line::No);
}

TEST(OutlineTruth, CornersApartByRounding_AreOne)
{
  Scene scene;
  addQuad(scene, {-5.0, -5.0, 0.0}, {5.0, 0.0, 0.0}, {0.0, 10.0, 0.0});
  addQuad(scene, {1e-7, -5.0, 1e-16}, {5.0, 0.0, 0.0}, {0.0, 10.0, 0.0});
  const View view = lookingDown(size, half, 10.0);
  EXPECT_NEAR(lengthOf(OutlineTruth(scene, view).pieces(), true), 40.0 * pixelsPerUnit, 1e-3);
  addQuad(scene, {1e-3, -5.0, -1.0}, {5.0, 0.0, 0.0}, {0.0, 10.0, 0.0});
  EXPECT_GT(lengthOf(OutlineTruth(scene, view).pieces(), true), 40.0 * pixelsPerUnit);
}

TEST(OutlineTruth, PartsThatTouch_AreNoNeighbours)
{
  Scene scene;
  addQuad(scene, {-5.0, -5.0, 0.0}, {5.0, 0.0, 0.0}, {0.0, 10.0, 0.0});
  addQuad(scene, {0.0, -5.0, 0.0}, {5.0, 0.0, 0.0}, {0.0, 10.0, 0.0});
  const View view = lookingDown(size, half, 10.0);
  expectRectangle(OutlineTruth(scene, view), glm::dvec2(5.0 * pixelsPerUnit));
  scene.triangles[2].part = scene.triangles[3].part = 1;
  EXPECT_NEAR(lengthOf(OutlineTruth(scene, view).pieces(), true), 60.0 * pixelsPerUnit, 1e-6);
}

TEST(OutlineTruth, EdgeThroughTheNearPlane_IsCutThere)
{
  // A road from far ahead to far behind the eye, one above it: its two long sides leave the view below.
  Scene scene;
  addQuad(scene, {-1.0, -100.0, -1.0}, {2.0, 0.0, 0.0}, {0.0, 150.0, 0.0});
  const View view = lookingAt({0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, size, size, 90.0);
  const OutlineTruth truth(scene, view);
  // At height y under the middle the road is as wide as y is low: 1 : 1 on each side.
  for (const int below : {8, 16, 24, 30})
  {
    for (const int side : {-1, 1})
    {
      const int x = size / 2 + side * below - (side < 0 ? 1 : 0);
      EXPECT_LT(truth.certainDistance(x, size / 2 - below), 0.8) << below;
      EXPECT_GT(truth.distance(size / 2, size / 2 - below), std::min(below / 1.5, 7.0) - 1.0) << below;
    }
  }
  EXPECT_EQ(truth.line(size / 2, size - 2, 8.0), OutlineTruth::Line::No) << "behind the eye";
}

TEST(OutlineTruth, SceneBehindTheEye_HasNoOutline)
{
  Scene scene;
  addFrustum(scene, 2.0);
  const View view = lookingAt({0.0, 0.0, 20.0}, {0.0, 0.0, 40.0}, size, size, 60.0);
  EXPECT_TRUE(OutlineTruth(scene, view).pieces().empty());
}

TEST(OutlineTruth, Creases_FromTheirAngleOn)
{
  Scene scene;
  addFrustum(scene, 2.0); // its sides are 45 degrees steep
  const View view = lookingDown(size, half, 10.0);
  OutlineOptions options;
  options.creaseDegrees = 46.0;
  const double bottomRim = 32.0 * pixelsPerUnit;
  // Between two sides the normals differ by 60 degrees.
  const double slanting = 4.0 * std::sqrt(8.0) * pixelsPerUnit;
  EXPECT_NEAR(lengthOf(OutlineTruth(scene, view, options).pieces(), true), bottomRim + slanting, 1e-3);
  options.creaseDegrees = 44.0;
  EXPECT_NEAR(lengthOf(OutlineTruth(scene, view, options).pieces(), true),
              bottomRim + slanting + 16.0 * pixelsPerUnit, 1e-3);
  options.creaseDegrees = 45.0;
  EXPECT_NEAR(lengthOf(OutlineTruth(scene, view, options).pieces(), false), 16.0 * pixelsPerUnit, 1e-3)
      << "an angle at the limit is uncertain";
}

TEST(OutlineTruth, EdgeOfThreeTriangles_IsAlwaysShown)
{
  Scene scene;
  addFloor(scene, 5.0);
  // A fin on the diagonal, in the plane of the eye: it is shown for belonging to three triangles.
  scene.triangles.push_back(makeTriangle({-5.0, -5.0, 0.0}, {5.0, 5.0, 0.0}, {-4.0, 4.0, -2.0}));
  const OutlineTruth truth(scene, lookingDown(size, half, 10.0));
  EXPECT_NEAR(lengthOf(truth.pieces(), true), (40.0 + std::sqrt(200.0)) * pixelsPerUnit, 1.0);
}

TEST(OutlineTruth, CulledFaces_HideNothing)
{
  Scene scene;
  addFloor(scene, 5.0);
  addFloor(scene, 7.0, 1.0);
  scene.triangles[2].part = scene.triangles[3].part = 1;
  const View view = lookingDown(size, half, 10.0);
  EXPECT_NEAR(lengthOf(OutlineTruth(scene, view).pieces(), true), 56.0 * pixelsPerUnit, 1e-6);
  scene.triangles[2].hideFront = scene.triangles[3].hideFront = true;
  EXPECT_NEAR(lengthOf(OutlineTruth(scene, view).pieces(), true), 96.0 * pixelsPerUnit, 1e-6);
}

} // namespace shadow::truth::test
