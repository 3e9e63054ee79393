#include <gtest/gtest.h>

#include "PixelRays.h"
#include "RayCaster.h"
#include "TruthTestScenes.h"

using namespace shadow::truth;

namespace
{

/// The answer at a world position, seen by a parallel camera straight from above.
Answer answerFromAbove(const Scene& scene, const glm::dvec3& light, double lightW,
                       const glm::dvec2& at = {0.1, 0.2}, double eyeZ = 50.0)
{
  const RayCaster caster(scene);
  const PixelRays rays(test::lookingDown(64, 2.0, eyeZ), caster.originWC());
  return caster.answer(rays.through((at.x + 2.0) * 16.0, (at.y + 2.0) * 16.0),
                       caster.localLight({glm::dvec4(light, lightW)}));
}

Scene floorOnly()
{
  Scene scene;
  test::addFloor(scene, 1.0);
  return scene;
}

/// A floor with a roof that the camera does not see through its culling flags, so that it looks at the floor.
Scene floorUnderRoof(double roofZ, bool roofFacesUp)
{
  Scene scene = floorOnly();
  const double turn = roofFacesUp ? 1.0 : -1.0;
  test::addQuad(scene, {-0.5, -0.5 * turn, roofZ}, {1.0, 0.0, 0.0}, {0.0, 1.0 * turn, 0.0});
  for (std::size_t i = 2; i < 4; ++i)
  {
    scene.triangles[i].hideFront = roofFacesUp;
    scene.triangles[i].hideBack = !roofFacesUp;
  }
  return scene;
}

/// What RayCaster answers, without its hierarchy.
Answer bruteForce(const std::vector<LocalTriangle>& triangles, const Ray& ray, const LocalLight& light)
{
  std::optional<Hit> nearest;
  for (const LocalTriangle& triangle : triangles)
  {
    const std::optional<Hit> hit = hitTriangle(triangle, ray);
    if (hit && (!nearest || hit->distance < nearest->distance))
    {
      nearest = hit;
    }
  }
  if (!nearest)
  {
    return Answer::Background;
  }
  const LocalTriangle& own = triangles[nearest->triangle];
  bool reached = sideOfPlane(own, light.position, light.rounding) == nearest->eyeSide;
  const glm::dvec3 direction = glm::dvec3(light.position) - light.position.w * nearest->point;
  for (const LocalTriangle& triangle : triangles)
  {
    reached = reached && (triangle.index == own.index ||
                          !blocks(triangle, nearest->point, own.rounding, direction, light));
  }
  return reached ? Answer::Reached : Answer::Shadowed;
}

} // namespace

TEST(Truth, EmptyScene_IsBackground)
{
  EXPECT_EQ(answerFromAbove(Scene(), {0, 0, 1}, 0.0), Answer::Background);
}

TEST(Truth, NothingBetween_IsReached)
{
  EXPECT_EQ(answerFromAbove(floorOnly(), {0.3, 0.4, 3.0}, 1.0), Answer::Reached);
  EXPECT_EQ(answerFromAbove(floorOnly(), {0.3, 0.4, 3.0}, 0.0), Answer::Reached);
}

TEST(Truth, BothSidesBlock)
{
  for (const bool facesUp : {false, true})
  {
    EXPECT_EQ(answerFromAbove(floorUnderRoof(1.0, facesUp), {0, 0, 3}, 1.0), Answer::Shadowed);
    EXPECT_EQ(answerFromAbove(floorUnderRoof(1.0, facesUp), {0, 0, 1}, 0.0), Answer::Shadowed);
    EXPECT_EQ(answerFromAbove(floorUnderRoof(1.0, facesUp), {0, 0, 3}, 1.0, {0.9, 0.9}), Answer::Reached);
  }
}

TEST(Truth, BehindTheLight_DoesNotBlock)
{
  EXPECT_EQ(answerFromAbove(floorUnderRoof(1.0, true), {0.1, 0.1, 0.5}, 1.0), Answer::Reached);
}

TEST(Truth, LightOnTheRoof_DoesNotBlock)
{
  EXPECT_EQ(answerFromAbove(floorUnderRoof(1.0, true), {0.2, 0.1, 1.0}, 1.0), Answer::Reached);
}

TEST(Truth, PropThatDoesNotCast_DoesNotBlock)
{
  Scene scene = floorUnderRoof(1.0, true);
  scene.triangles[2].casts = scene.triangles[3].casts = false;
  EXPECT_EQ(answerFromAbove(scene, {0, 0, 3}, 1.0), Answer::Reached);
}

TEST(Truth, LightOnTheOtherSide_IsShadow)
{
  EXPECT_EQ(answerFromAbove(floorOnly(), {0, 0, -3}, 1.0), Answer::Shadowed);
  EXPECT_EQ(answerFromAbove(floorOnly(), {0, 0, -3}, 0.0), Answer::Shadowed);
}

TEST(Truth, SeenFromBehind_TheVisibleSideCounts)
{
  Scene scene;
  test::addQuad(scene, {-1, 1, 0}, {2, 0, 0}, {0, -2, 0}); // faces down, seen from above
  EXPECT_EQ(answerFromAbove(scene, {0, 0, 3}, 1.0), Answer::Reached);
  EXPECT_EQ(answerFromAbove(scene, {0, 0, -3}, 1.0), Answer::Shadowed);
}

TEST(Truth, CulledFaces_AreSeenThrough)
{
  Scene scene = floorOnly();
  for (Triangle& triangle : scene.triangles)
  {
    triangle.hideFront = true;
  }
  EXPECT_EQ(answerFromAbove(scene, {0, 0, 3}, 1.0), Answer::Background);
}

TEST(Truth, InFrontOfTheNearPlane_IsNotSeenButCasts)
{
  Scene scene = floorOnly();
  test::addFloor(scene, 0.5, 2.0);
  EXPECT_EQ(answerFromAbove(scene, {0, 0, 9}, 1.0, {0.1, 0.2}, 3.0), Answer::Reached);
  EXPECT_EQ(answerFromAbove(scene, {0, 0, 9}, 1.0, {0.1, 0.2}, 1.0), Answer::Shadowed);
}

TEST(Truth, BeyondTheFarPlane_IsSeen)
{
  Scene scene;
  test::addFloor(scene, 1e6, -1e7);
  EXPECT_EQ(answerFromAbove(scene, {0, 0, 1}, 0.0), Answer::Reached);
}

TEST(Truth, CoordinatesThatAreNotFinite_AreLeftOut)
{
  Scene scene = floorOnly();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  scene.triangles.push_back(test::makeTriangle({-1, -1, nan}, {1, -1, 1}, {0, 1, 1}));
  scene.triangles.push_back(test::makeTriangle({-1, -1, 1}, {inf, -1, 1}, {0, 1, 1}));
  EXPECT_EQ(answerFromAbove(scene, {0, 0, 3}, 1.0), Answer::Reached);
}

TEST(Truth, LightWithoutDirection_IsShadow)
{
  EXPECT_EQ(answerFromAbove(floorOnly(), {0, 0, 0}, 0.0), Answer::Shadowed);
}

TEST(Truth, BvhEqualsBruteForce)
{
  for (unsigned seed = 0; seed < 8; ++seed)
  {
    const Scene scene = test::randomSoup(seed, 40 << (seed % 4), 0.4);
    const RayCaster caster(scene);
    std::vector<LocalTriangle> triangles;
    for (std::size_t i = 0; i < scene.triangles.size(); ++i)
    {
      const Triangle& t = scene.triangles[i];
      const double largest =
          std::max({largestCoordinate(t.a), largestCoordinate(t.b), largestCoordinate(t.c)});
      triangles.push_back({t.a - caster.originWC(), t.b - caster.originWC(), t.c - caster.originWC(),
                           vertexRounding(largest), static_cast<std::uint32_t>(i), t.casts, t.hideFront,
                           t.hideBack});
    }
    const PixelRays rays(test::lookingAt({2, -2, 1.5}, {0, 0, 0}, 64, 48), caster.originWC());
    const double w = seed % 2 == 0 ? 1.0 : 0.0;
    const LocalLight light = caster.localLight({glm::dvec4(0.8 - 0.2 * seed, -0.9, 1.4, w)});
    for (int y = 0; y < 48; ++y)
    {
      for (int x = 0; x < 64; ++x)
      {
        const Ray ray = rays.through(x + 0.5, y + 0.5);
        ASSERT_EQ(caster.answer(ray, light), bruteForce(triangles, ray, light))
            << seed << " " << x << " " << y;
      }
    }
  }
}
