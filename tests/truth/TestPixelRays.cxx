#include <gtest/gtest.h>

#include "PixelRays.h"
#include "TruthTestScenes.h"

using namespace shadow::truth;

namespace
{

struct NamedView
{
  const char* name;
  View view;
};

std::vector<NamedView> views()
{
  const glm::dmat4 camera = glm::lookAt(glm::dvec3(3, -4, 2), glm::dvec3(0.1, 0.2, 0.3), glm::dvec3(0, 0, 1));
  const glm::dmat4 far =
      glm::lookAt(glm::dvec3(3e5, -4e5, 2e5), glm::dvec3(0.1, 0.2, 0.3), glm::dvec3(0, 0, 1));
  glm::dmat4 shear(1.0);
  shear[2][0] = 0.3;
  shear[2][1] = -0.2;
  const glm::dmat4 ortho = glm::ortho(-2.0, 2.0, -1.5, 1.5, 0.5, 20.0);
  return {
      {"perspective", {glm::perspective(0.6, 4.0 / 3.0, 0.1, 100.0) * camera, 640, 480}},
      {"stretched", {glm::perspective(0.6, 0.4, 0.1, 100.0) * camera, 640, 480}},
      {"off-centre", {glm::frustum(-0.02, 0.09, 0.01, 0.07, 0.1, 50.0) * camera, 333, 777}},
      {"parallel", {ortho * camera, 640, 480}},
      {"sheared parallel", {ortho * shear * camera, 640, 480}},
      {"mirrored", {glm::scale(glm::dmat4(1.0), glm::dvec3(-1, 1, 1)) * ortho * camera, 640, 480}},
      {"narrow and far away", {glm::perspective(5e-6, 4.0 / 3.0, 1e5, 1e6) * far, 640, 480}},
      {"near plane at almost 0", {glm::perspective(2.5, 4.0 / 3.0, 1e-5, 1e9) * camera, 640, 480}},
  };
}

glm::dvec3 windowFromClip(const View& view, const glm::dvec4& clip)
{
  return {(clip.x / clip.w + 1.0) * 0.5 * view.width, (clip.y / clip.w + 1.0) * 0.5 * view.height,
          clip.z / clip.w};
}

} // namespace

TEST(PixelRays, EveryView_PointsOfTheRayProjectToThePixelCentre)
{
  const glm::dvec3 origin(1.0, -2.0, 0.5);
  for (const NamedView& named : views())
  {
    SCOPED_TRACE(named.name);
    const PixelRays rays(named.view, origin);
    for (const glm::ivec2 pixel : {glm::ivec2(0, 0), glm::ivec2(100, 31), glm::ivec2(332, 479)})
    {
      const Ray ray = rays.through(pixel.x + 0.5, pixel.y + 0.5);
      for (const double distance : {0.0, 1.0, 10.0})
      {
        const glm::dvec3 point = ray.origin + distance * ray.direction + origin;
        const glm::dvec3 window = windowFromClip(named.view, named.view.clipFromWC * glm::dvec4(point, 1.0));
        EXPECT_NEAR(window.x, pixel.x + 0.5, 1e-6);
        EXPECT_NEAR(window.y, pixel.y + 0.5, 1e-6);
      }
    }
  }
}

TEST(PixelRays, EveryView_StartsOnTheNearPlaneAndRunsInto)
{
  for (const NamedView& named : views())
  {
    SCOPED_TRACE(named.name);
    const Ray ray = PixelRays(named.view, glm::dvec3(0.0)).through(5.5, 7.5);
    EXPECT_NEAR(glm::length(ray.direction), 1.0, 1e-14);
    const auto nearValue = [&](double distance)
    {
      const glm::dvec4 clip = named.view.clipFromWC * glm::dvec4(ray.origin + distance * ray.direction, 1.0);
      return clip.z + clip.w;
    };
    EXPECT_NEAR(nearValue(0.0), 0.0, 1e-9 * std::abs(nearValue(1e6)));
    EXPECT_GT(nearValue(1.0), nearValue(0.0));
  }
}

TEST(PixelRays, RowZeroIsTheLowest)
{
  const View view = test::lookingAt({0, -5, 0}, {0, 0, 0}, 64, 64);
  const PixelRays rays(view, glm::dvec3(0.0));
  EXPECT_LT(rays.through(32.0, 0.5).direction.z, 0.0);
  EXPECT_GT(rays.through(32.0, 63.5).direction.z, 0.0);
  EXPECT_LT(rays.through(0.5, 32.0).direction.x, 0.0);
}

TEST(PixelRays, MirroredView_FrontsTurnTheOtherWay)
{
  for (const NamedView& named : views())
  {
    SCOPED_TRACE(named.name);
    const bool mirrored = std::string(named.name) == "mirrored";
    EXPECT_EQ(PixelRays(named.view, glm::dvec3(0.0)).through(1.5, 1.5).frontSign, mirrored ? 1.0 : -1.0);
  }
}
