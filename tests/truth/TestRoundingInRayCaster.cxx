#include <gtest/gtest.h>

#include "MaskTruth.h"
#include "TruthTestScenes.h"

using namespace shadow::truth;

namespace
{

/// Pixels that see a triangle facing the light, and how many of them the light does not reach.
struct Count
{
  int facing = 0, shadowed = 0;
};

Count countFacing(const Scene& scene, const View& view, const Light& light)
{
  const RayCaster caster(scene);
  const PixelRays rays(view, caster.originWC());
  const LocalLight local = caster.localLight(light);
  Count count;
  for (int y = 0; y < view.height; ++y)
  {
    for (int x = 0; x < view.width; ++x)
    {
      const std::optional<Hit> hit = caster.firstHit(rays.through(x + 0.5, y + 0.5));
      if (hit)
      {
        const Triangle& t = scene.triangles[hit->triangle];
        const glm::dvec3 normal = glm::normalize(glm::cross(t.b - t.a, t.c - t.a)) * double(hit->eyeSide);
        const glm::dvec4 l = light.positionWC;
        const bool faces = glm::dot(normal, glm::dvec3(l) - l.w * t.a) > 1e-6;
        count.facing += faces;
        count.shadowed += faces && !caster.isReached(*hit, local);
      }
    }
  }
  return count;
}

void addGrid(Scene& scene, int cells)
{
  for (int i = 0; i < cells; ++i)
  {
    for (int j = 0; j < cells; ++j)
    {
      const double step = 2.0 / cells;
      test::addQuad(scene, {-1.0 + i * step, -1.0 + j * step, 0.0}, {step, 0, 0}, {0, step, 0});
    }
  }
}

Scene sphereOnFloor()
{
  Scene scene;
  test::addFloor(scene, 2.0);
  test::addSphere(scene, {0.1, 0.2, 0.6}, 0.5, 48);
  return scene;
}

std::size_t differences(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    count += a[i] != b[i];
  }
  return count;
}

} // namespace

TEST(Truth, SelfNeighboursNeverBlock)
{
  Scene sphere;
  test::addSphere(sphere, glm::dvec3(0.0), 1.0, 96);
  const Scene scene = test::transformed(sphere, test::oddRotation());
  const View view = test::lookingAt({2, -3, 1}, {0, 0, 0}, 256, 256);
  for (const glm::dvec4 light :
       {glm::dvec4(3, 2, 4, 1), glm::dvec4(-1, 0.2, 0.1, 0), glm::dvec4(0.1, 0.3, 1.2, 1)})
  {
    const Count count = countFacing(scene, view, {light});
    EXPECT_GT(count.facing, 100);
    EXPECT_EQ(count.shadowed, 0);
  }
}

TEST(Truth, InsideAConvexMesh_EverythingIsReached)
{
  Scene sphere;
  test::addSphere(sphere, glm::dvec3(0.0), 1.0, 64);
  const Scene scene = test::transformed(sphere, test::oddRotation());
  const View view = test::lookingAt({0.5, 0.1, 0.2}, {0, 0, 0}, 256, 256, 90.0);
  const Count count = countFacing(scene, view, {glm::dvec4(-0.7, 0.1, 0.3, 1)});
  EXPECT_EQ(count.facing, 256 * 256);
  EXPECT_EQ(count.shadowed, 0);
}

TEST(Truth, TessellatedPlane_GrazingLightReachesAll)
{
  Scene grid;
  addGrid(grid, 37);
  const Scene scene = test::transformed(grid, test::oddRotation());
  const glm::dmat3 turn(test::oddRotation());
  const View view = test::lookingAt(turn * glm::dvec3(0.3, -1, 2), {0, 0, 0}, 200, 200);
  for (const double slope : {1.0, 1e-3, 1e-6})
  {
    const Count count =
        countFacing(scene, view, {glm::dvec4(turn * glm::dvec3(1.0, 0.37, 3.0 * slope), 0.0)});
    EXPECT_GT(count.facing, 10000);
    EXPECT_EQ(count.shadowed, 0);
  }
}

TEST(Truth, CoincidentDuplicateDoesNotBlock)
{
  Scene floor;
  test::addFloor(floor, 1.0);
  Scene scene = test::transformed(floor, test::oddRotation());
  // Duplicates: vertices in another order, the other winding, and reached through a different matrix product.
  for (const Triangle& t : std::vector<Triangle>(scene.triangles))
  {
    scene.triangles.push_back(test::makeTriangle(t.b, t.c, t.a));
    scene.triangles.push_back(test::makeTriangle(t.a, t.c, t.b));
  }
  const glm::dmat4 there = glm::translate(glm::dmat4(1.0), glm::dvec3(0.3, 0.7, -0.1)) * test::oddRotation();
  const Scene detour = test::transformed(
      test::transformed(test::transformed(floor, there), glm::inverse(there)), test::oddRotation());
  scene.triangles.insert(scene.triangles.end(), detour.triangles.begin(), detour.triangles.end());

  const glm::dmat3 turn(test::oddRotation());
  const View view = test::lookingAt(turn * glm::dvec3(0.3, -1, 2), {0, 0, 0}, 200, 200);
  const Count count = countFacing(scene, view, {glm::dvec4(turn * glm::dvec3(0.4, 0.3, 0.2), 1.0)});
  EXPECT_GT(count.facing, 10000);
  EXPECT_EQ(count.shadowed, 0);
}

TEST(Truth, LightInPlaneIsShadow)
{
  for (const glm::dmat4& turn : {glm::dmat4(1.0), test::oddRotation()})
  {
    Scene grid;
    addGrid(grid, 9);
    const Scene scene = test::transformed(grid, turn);
    const RayCaster caster(scene);
    const View view = test::lookingAt(glm::dmat3(turn) * glm::dvec3(0.3, -1, 2), {0, 0, 0}, 64, 64);
    for (const glm::dvec4 light :
         {glm::dvec4(5, 3, 0, 1), glm::dvec4(0.1, 0.2, 0, 1), glm::dvec4(1, 0.3, 0, 0)})
    {
      const MaskTruth truth(caster, view, {turn * light});
      const PixelRays rays(view, caster.originWC());
      EXPECT_TRUE(caster.firstHit(rays.through(32.5, 32.5)));
      EXPECT_EQ(truth.mask()[32 * 64 + 32], 0);
    }
  }
}

TEST(Truth, BetweenTwoTriangles_NoLightSlipsThrough)
{
  // The light falls along z: shadow rays pass exactly through the diagonals and vertices of the roof, and the
  // camera rays exactly through those of the floor.
  Scene scene;
  test::addFloor(scene, 1.0);
  for (int i = -4; i < 4; ++i)
  {
    for (int j = -4; j < 4; ++j)
    {
      test::addQuad(scene, {0.25 * i, 0.25 * j, 0.5}, {0.25, 0, 0}, {0, 0.25, 0});
    }
  }
  for (std::size_t i = 2; i < scene.triangles.size(); ++i)
  {
    scene.triangles[i].hideFront = true;
  }
  const RayCaster caster(scene);
  const PixelRays rays(test::lookingDown(64, 1.0, 10.0), caster.originWC());
  const LocalLight light = caster.localLight({glm::dvec4(0, 0, 1, 0)});
  for (int x = 1; x < 128; ++x)
  {
    for (int y = 1; y < 128; ++y)
    {
      ASSERT_EQ(caster.answer(rays.through(0.5 * x, 0.5 * y), light), Answer::Shadowed) << x << " " << y;
    }
  }
}

TEST(Truth, SliversAndZeroArea_ChangeNothing)
{
  Scene scene = sphereOnFloor();
  const View view = test::lookingAt({2, -3, 3}, {0, 0, 0.3}, 160, 120);
  const Light light{glm::dvec4(1.5, 1, 4, 1)};
  const std::vector<unsigned char> before = MaskTruth(RayCaster(scene), view, light).mask();
  scene.triangles.push_back(test::makeTriangle({-1, -1, 1}, {-1, -1, 1}, {1, 1, 1}));
  scene.triangles.push_back(test::makeTriangle({0.7, 0.7, 1}, {0.7, 0.7, 1}, {0.7, 0.7, 1}));
  scene.triangles.push_back(test::makeTriangle({-1, 0.1, 0}, {1, 0.3, 1}, {0.0, 0.2, 0.5}));
  scene.triangles.push_back(test::makeTriangle({-1, 0.1, 0}, {1, 0.3, 1}, {0.0, 0.2 + 1e-16, 0.5}));
  EXPECT_EQ(differences(MaskTruth(RayCaster(scene), view, light).mask(), before), 0u);
}

TEST(Truth, OffsetScene_SameAnswer)
{
  const Scene scene = sphereOnFloor();
  const View view = test::lookingAt({2, -3, 3}, {0, 0, 0.3}, 160, 120);
  const glm::dvec4 light(1.5, 1, 4, 1);
  const RayCaster near(scene);
  const std::vector<unsigned char> expected = MaskTruth(near, view, {light}).mask();

  const glm::dvec3 offset(1e7, -2e7, 1.3e7);
  const RayCaster far(test::transformed(scene, glm::translate(glm::dmat4(1.0), offset)));
  const View farView{view.clipFromWC * glm::translate(glm::dmat4(1.0), -offset), view.width, view.height};
  const MaskTruth truth(far, farView, {light + glm::dvec4(offset, 0.0)});
  EXPECT_LE(differences(truth.mask(), expected), 1u);
}

TEST(Truth, ScaledScene_SameAnswer)
{
  const Scene scene = sphereOnFloor();
  const View view = test::lookingAt({2, -3, 3}, {0, 0, 0.3}, 160, 120);
  const RayCaster caster(scene);
  for (const glm::dvec4 light : {glm::dvec4(1.5, 1, 4, 1), glm::dvec4(1.5, 1, 4, 0)})
  {
    const std::vector<unsigned char> expected = MaskTruth(caster, view, {light}).mask();
    for (const double factor : {1e-6, 1e9})
    {
      const RayCaster scaled(test::transformed(scene, glm::scale(glm::dmat4(1.0), glm::dvec3(factor))));
      const View scaledView{view.clipFromWC * glm::scale(glm::dmat4(1.0), glm::dvec3(1.0 / factor)),
                            view.width, view.height};
      const MaskTruth truth(scaled, scaledView, {glm::dvec4(glm::dvec3(light) * factor, light.w)});
      EXPECT_LE(differences(truth.mask(), expected), 1u);
    }
  }
}
