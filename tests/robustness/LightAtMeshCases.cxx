// Where the light is: in the plane of, on, or inside a mesh.
#include "HardCase.h"
#include "HardScene.h"

namespace shadow::robustness
{

namespace
{

// At the height of the top face: all its triangles are edge-on, and the shadow on the ground never ends.
void lightInTopPlaneOfGridCube(HardScene& scene)
{
  scene.addMesh(makeGridCube({0.0, 0.5, 0.0}, 1.0, 16));
  scene.addGround();
  scene.addPointLight(-2.5, 1.0, 0.3);
  scene.lookAtGround();
}

// In the planes of two faces and of every triangle of the ground.
void lightInGroundPlane(HardScene& scene)
{
  scene.addMesh(makeGridCube({0.0, 0.5, 0.0}, 1.0, 8));
  scene.addMesh(makeGrid({-4.0, 0.0, -4.0}, {0.0, 0.0, 8.0}, {8.0, 0.0, 0.0}, 8));
  scene.addPointLight(1.0, 0.0, 2.5);
  scene.lookAtGround();
}

// In the plane of a triangle on the upper outside of the ring, above the ground.
void lightInPlaneOfTorusTriangle(HardScene& scene)
{
  const TriangleSoup torus = moved(upright(test::makeTorus(1.0, 0.35, 96, 48)), {0.0, 0.8, 0.0});
  scene.addMesh(torus);
  scene.addGround();
  const auto& corners = torus.triangles[2 * (10 * 48 + 8)];
  const glm::dvec3 a = torus.points[corners[0]];
  const glm::dvec3 b = torus.points[corners[1]];
  const glm::dvec3 c = torus.points[corners[2]];
  const glm::dvec3 position = a + 30.0 * (b - a) + 40.0 * (c - b);
  scene.addPointLight(position.x, position.y, position.z);
  scene.lookAtGround();
}

// On the torus's plane of symmetry, in the plane of whole rings of edges.
void lightInSymmetryPlaneOfTorus(HardScene& scene)
{
  scene.addMesh(moved(upright(test::makeTorus(1.0, 0.35, 96, 48)), {0.0, 0.75, 0.0}));
  scene.addGround();
  scene.addPointLight(-3.0, 0.75, 0.0);
  scene.addDirectionalLight(0.0, -1.0, 0.0);
  scene.lookAtGround();
}

// Every page is edge-on.
void lightOnSpineOfBook(HardScene& scene)
{
  scene.addMesh(moved(upright(test::makeBook(9)), {0.0, 1.2, 0.0}));
  scene.addCube({1.8, 0.0, 0.4}, 0.6);
  scene.addGround();
  scene.addPointLight(0.0, 3.0, 0.0);
  scene.lookAtGround();
}

void lightAtVertexOfClosedMesh(HardScene& scene)
{
  scene.addCube({0.0, 0.0, 0.0});
  scene.addCube({-1.5, 0.0, 0.5}, 0.5);
  scene.addCube({1.5, 0.0, 0.5}, 0.5);
  scene.addGround();
  scene.addPointLight(0.5, 1.0, 0.5);
  scene.lookAtGround();
}

void lightAtVertexOfOpenMesh(HardScene& scene)
{
  TriangleSoup tent;
  tent.points = {{0.0, 1.5, 0.0}, {-1.0, 0.5, -1.0}, {1.0, 0.5, -1.0}, {1.0, 0.5, 1.0}, {-1.0, 0.5, 1.0}};
  tent.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
  scene.addMesh(tent);
  scene.addCube({-1.8, 0.0, 0.5}, 0.5);
  scene.addGround();
  scene.addPointLight(0.0, 1.5, 0.0);
  scene.lookAtGround();
}

void lightOnEdgeOfClosedMesh(HardScene& scene)
{
  scene.addCube({0.0, 0.0, 0.0});
  scene.addCube({-1.5, 0.0, 0.5}, 0.5);
  scene.addCube({1.5, 0.0, 0.5}, 0.5);
  scene.addGround();
  scene.addPointLight(0.25, 1.0, 0.5);
  scene.lookAtGround();
}

void lightOnEdgeOfOpenMesh(HardScene& scene)
{
  scene.addPlate({-0.8, 1.0, -0.5}, {1.6, 0.0, 0.0}, {0.0, 0.5, 1.0});
  scene.addCube({0.3, 0.0, 0.5}, 0.5);
  scene.addGround();
  scene.addPointLight(0.1, 1.5, 0.5);
  scene.lookAtGround();
}

void lightOnFaceOfClosedMesh(HardScene& scene)
{
  scene.addCube({0.0, 0.0, 0.0});
  scene.addCube({-1.2, 0.0, 1.3}, 0.5);
  scene.addGround();
  scene.addPointLight(0.1, 0.7, 0.5);
  scene.lookAtGround();
}

void lightOnFaceOfOpenMesh(HardScene& scene)
{
  scene.addPlate({-1.0, 1.5, -1.0}, {2.0, 0.0, 0.0}, {0.0, 0.0, 2.0});
  scene.addCube({0.0, 0.0, 0.4}, 0.5);
  scene.addGround();
  scene.addPointLight(0.2, 1.5, -0.3);
  scene.lookAtGround();
}

// All outside is in shadow; a cube outside, and one inside that cannot be seen.
void lightInsideClosedMesh(HardScene& scene)
{
  scene.addMesh(moved(upright(test::makeSphere(0.8, 32, 16)), {0.0, 1.0, 0.0}));
  scene.addCube({1.7, 0.0, 0.5}, 0.5);
  scene.addGround();
  scene.addPointLight(0.2, 1.1, 0.1);
  scene.lookAtGround();
}

// One mesh of several closed parts; the light is inside one of them.
void lightInsideOnePartOfClosedMesh(HardScene& scene)
{
  TriangleSoup soup = moved(upright(test::makeSphere(0.4, 24, 12)), {-1.5, 1.3, 0.0});
  test::append(soup, test::makeCube({0.6, 0.5, 0.0}, 1.0));
  test::append(soup, test::makeCube({-1.5, 1.3, 0.0}, 0.1));
  scene.addMesh(soup);
  scene.addGround();
  scene.addPointLight(-1.4, 1.45, 0.12);
  scene.lookAtGround();
}

// Light, camera and a few things in a closed room.
void lightAndCameraInsideRoom(HardScene& scene)
{
  TriangleSoup room = test::makeCube({0.0, 4.0, 0.0}, 8.0);
  scene.addMesh(room);
  scene.addMesh(moved(upright(test::makeTorus(0.8, 0.25, 48, 24)), {0.3, 1.0, 0.2}));
  scene.addCube({-1.5, 0.0, 0.5}, 0.8);
  scene.addPointLight(1.1, 3.4, 1.7);
  scene.look({1.0, 2.2, 3.8}, {0.0, 0.6, 0.0}, 70.0);
}

void lightInsideOpenCylinder(HardScene& scene)
{
  scene.addMesh(moved(upright(scaled(test::makeOpenCylinder(48), 0.6)), {0.0, 0.9, 0.0}));
  scene.addCube({1.5, 0.0, 0.5}, 0.6);
  scene.addGround();
  scene.addPointLight(0.1, 1.2, -0.1);
  scene.lookAtGround();
}

void lightInsideDome(HardScene& scene)
{
  scene.addMesh(moved(makeDome(0.7, 48), {0.0, 1.0, 0.0}));
  scene.addCube({0.8, 0.0, 0.8}, 0.4);
  scene.addGround();
  scene.addPointLight(0.0, 1.3, 0.0);
  scene.lookAtGround();
}

} // namespace

std::vector<HardCase> lightAtMeshCases()
{
  return {
      {"LightInTopPlaneOfGridCube", lightInTopPlaneOfGridCube},
      {"LightInGroundPlane", lightInGroundPlane},
      {"LightInPlaneOfTorusTriangle", lightInPlaneOfTorusTriangle},
      {"LightInSymmetryPlaneOfTorus", lightInSymmetryPlaneOfTorus},
      {"LightOnSpineOfBook", lightOnSpineOfBook},
      {"LightAtVertexOfClosedMesh", lightAtVertexOfClosedMesh},
      {"LightAtVertexOfOpenMesh", lightAtVertexOfOpenMesh},
      {"LightOnEdgeOfClosedMesh", lightOnEdgeOfClosedMesh},
      {"LightOnEdgeOfOpenMesh", lightOnEdgeOfOpenMesh},
      {"LightOnFaceOfClosedMesh", lightOnFaceOfClosedMesh},
      {"LightOnFaceOfOpenMesh", lightOnFaceOfOpenMesh},
      {"LightInsideClosedMesh", lightInsideClosedMesh, false},
      {"LightInsideOnePartOfClosedMesh", lightInsideOnePartOfClosedMesh, false},
      {"LightAndCameraInsideRoom", lightAndCameraInsideRoom},
      {"LightInsideOpenCylinder", lightInsideOpenCylinder, false},
      {"LightInsideDome", lightInsideDome, false},
  };
}

} // namespace shadow::robustness
