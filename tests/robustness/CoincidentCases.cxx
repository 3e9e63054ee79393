// What lies on, in or against something else of the same place.
#include "HardCase.h"
#include "HardScene.h"

namespace shadow::robustness
{

namespace
{

void twoCoincidentCasters(HardScene& scene)
{
  scene.addMesh(makeRing());
  scene.show(makeRing());
}

void coincidentCastersWoundOppositely(HardScene& scene)
{
  TriangleSoup turned = makeRing();
  test::turnInsideOut(turned);
  scene.addMesh(turned);
  scene.show(makeRing());
}

// Sheets that lie on each other, the same points in another order, one wound the other way.
void coincidentOpenCasters(HardScene& scene)
{
  scene.addPlate({-1.0, 0.8, -0.8}, {2.0, 0.3, 0.0}, {0.0, 0.2, 1.6});
  TriangleSoup other = makeQuad({-1.0, 0.8, -0.8}, {2.0, 0.3, 0.0}, {0.0, 0.2, 1.6});
  other.triangles = {{2, 1, 0}, {3, 2, 0}};
  scene.show(other);
}

// A sheet, and on a part of it another one in its plane, of other triangles.
void coplanarCasters(HardScene& scene)
{
  const glm::dvec3 corner(-1.03, 0.81, -0.77), u(2.1, 0.3, 0.1), v(0.07, 0.2, 1.6);
  scene.addMesh(makeGrid(corner, u, v, 1));
  scene.show(makeGrid(corner + 0.2 * u + 0.3 * v, 0.6 * u, 0.5 * v, 3));
}

void coplanarPartsOfOneMesh(HardScene& scene)
{
  const glm::dvec3 corner(-1.03, 0.81, -0.77), u(2.1, 0.3, 0.1), v(0.07, 0.2, 1.6);
  TriangleSoup soup = makeGrid(corner, u, v, 1);
  test::append(soup, makeGrid(corner + 0.2 * u + 0.3 * v, 0.6 * u, 0.5 * v, 3));
  scene.show(soup);
}

// A carpet without thickness on the ground, and a cube on both.
void carpetOnGround(HardScene& scene)
{
  scene.addMesh(makeGrid({-1.0, 0.0, -1.0}, {2.0, 0.0, 0.0}, {0.0, 0.0, 2.0}, 3));
  scene.addCube({0.0, 0.0, 0.0}, 0.7);
  scene.finish();
}

// Two cubes that share a whole face, and one that stands on another.
void touchingFaces(HardScene& scene)
{
  scene.addCube({-0.5, 0.0, 0.0});
  scene.addCube({0.5, 0.0, 0.0});
  scene.addMesh(test::makeCube({0.5, 1.25, 0.0}, 0.5));
  scene.finish();
}

} // namespace

std::vector<HardCase> coincidentCases()
{
  return {
      {"TwoCoincidentCasters", twoCoincidentCasters},
      {"CoincidentCastersWoundOppositely", coincidentCastersWoundOppositely},
      {"CoincidentOpenCasters", coincidentOpenCasters},
      {"TouchingFaces", touchingFaces},
      {"CoplanarCasters", coplanarCasters},
      {"CoplanarPartsOfOneMesh", coplanarPartsOfOneMesh},
      {"CarpetOnGround", carpetOnGround},
  };
}

} // namespace shadow::robustness
