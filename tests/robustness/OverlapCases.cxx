// More layers between light and surface than an 8-bit stencil can count.
#include "HardCase.h"
#include "HardScene.h"

namespace shadow::robustness
{

namespace
{

/// Small plates above each other, over the ground and below the light.
TriangleSoup makeStack(int plates)
{
  return moved(upright(scaled(test::makePlates(static_cast<std::uint32_t>(plates)), 0.5)), {0.0, 0.6, 0.0});
}

/// The stack pressed to a height of about 1.
TriangleSoup makeLowStack(int plates)
{
  TriangleSoup soup = makeStack(plates);
  for (glm::dvec3& point : soup.points)
  {
    point.y = 0.6 + (point.y - 0.6) * 2.0 / plates;
  }
  return soup;
}

void finish(HardScene& scene)
{
  scene.addCube({-1.8, 0.0, 0.8}, 0.5);
  scene.addGround();
  scene.addPointLight(-0.3, 6.0, 0.4);
  scene.addDirectionalLight(0.15, -1.0, 0.1);
  scene.lookAtGround();
}

void addSeparately(HardScene& scene, int plates)
{
  const TriangleSoup stack = makeLowStack(plates);
  for (std::size_t plate = 0; plate < static_cast<std::size_t>(plates); ++plate)
  {
    TriangleSoup one;
    one.points.assign(stack.points.begin() + static_cast<std::ptrdiff_t>(4 * plate),
                      stack.points.begin() + static_cast<std::ptrdiff_t>(4 * plate + 4));
    one.triangles = {{0, 1, 2}, {0, 2, 3}};
    scene.addMesh(one);
  }
  finish(scene);
}

void addAsOneMesh(HardScene& scene, int plates)
{
  scene.addMesh(makeLowStack(plates));
  finish(scene);
}

void casters256(HardScene& scene)
{
  addSeparately(scene, 256);
}

void casters300(HardScene& scene)
{
  addSeparately(scene, 300);
}

void plates255InOneMesh(HardScene& scene)
{
  addAsOneMesh(scene, 255);
}

void plates256InOneMesh(HardScene& scene)
{
  addAsOneMesh(scene, 256);
}

void plates300InOneMesh(HardScene& scene)
{
  addAsOneMesh(scene, 300);
}

void plates512InOneMesh(HardScene& scene)
{
  addAsOneMesh(scene, 512);
}

// Closed boxes: a ray enters 256 of them, and leaves as many where it is not stopped.
void boxes256InOneMesh(HardScene& scene)
{
  TriangleSoup soup;
  for (int i = 0; i < 256; ++i)
  {
    test::append(soup, moved(scaled(test::makeCube(glm::dvec3(0.0), 1.0), 1.0), {0.0, 0.7 + 0.005 * i, 0.0}));
  }
  scene.addMesh(soup);
  finish(scene);
}

void triangle256TimesInOneMesh(HardScene& scene)
{
  TriangleSoup soup;
  soup.points = {{-1.0, 0.9, 0.5}, {1.2, 0.9, 0.3}, {0.1, 1.3, -0.9}};
  soup.triangles.assign(256, {0, 1, 2});
  scene.addMesh(soup);
  finish(scene);
}

void casters256AroundCamera(HardScene& scene)
{
  for (int i = 0; i < 256; ++i)
  {
    scene.addPlate({0.0, 3.0 + 0.01 * i, 3.5}, {2.0, 0.0, 0.0}, {0.0, 0.0, 2.0});
  }
  scene.addCube({-0.9, 0.0, 0.2});
  scene.addGround(6.0);
  scene.addPointLight(1.2, 9.0, 4.0);
  scene.look({1.0, 1.5, 4.5}, {0.0, 0.3, 0.0}, 50.0);
}

} // namespace

std::vector<HardCase> overlapCases()
{
  return {
      {"Casters256", casters256},
      {"Casters300", casters300},
      {"Plates255InOneMesh", plates255InOneMesh},
      {"Plates256InOneMesh", plates256InOneMesh},
      {"Plates300InOneMesh", plates300InOneMesh},
      {"Plates512InOneMesh", plates512InOneMesh},
      {"Boxes256InOneMesh", boxes256InOneMesh},
      {"Triangle256TimesInOneMesh", triangle256TimesInOneMesh},
      {"Casters256AroundCamera", casters256AroundCamera, false},
  };
}

} // namespace shadow::robustness
