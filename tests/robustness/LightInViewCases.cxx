// Where the light is: to the camera and its near plane, and which way it shines.
#include <vtkCamera.h>

#include "HardCase.h"
#include "HardScene.h"

namespace shadow::robustness
{

namespace
{

void lightAtCamera(HardScene& scene)
{
  scene.addSolids();
  scene.addPointLight(2.5, 4.0, 6.5);
  scene.lookAtGround();
}

void lightBehindCamera(HardScene& scene)
{
  scene.addSolids();
  scene.addPointLight(4.0, 7.0, 10.0);
  scene.lookAtGround();
}

/// A light on the line from the eye to the focal point, a little off it, with the near plane 2 away from the
/// eye.
void addLightBeforeEye(HardScene& scene, double distance)
{
  const glm::dvec3 eye(2.5, 4.0, 6.5);
  const glm::dvec3 way = glm::normalize(glm::dvec3(0.0, 0.4, 0.0) - eye);
  const glm::dvec3 aside = glm::normalize(glm::cross(way, glm::dvec3(0.0, 1.0, 0.0)));
  const glm::dvec3 light = eye + distance * way + 0.25 * aside;
  scene.addPointLight(light.x, light.y, light.z);
  scene.lookAtGround();
  scene.renderer->GetActiveCamera()->SetClippingRange(2.0, 30.0);
}

void lightBetweenEyeAndNearPlane(HardScene& scene)
{
  scene.addSolids();
  addLightBeforeEye(scene, 1.0);
}

void lightOnNearPlane(HardScene& scene)
{
  scene.addSolids();
  addLightBeforeEye(scene, 2.0);
}

void lightJustBeyondNearPlane(HardScene& scene)
{
  scene.addSolids();
  addLightBeforeEye(scene, 2.001);
}

void lightInView(HardScene& scene)
{
  scene.addSolids();
  scene.addPointLight(0.1, 1.2, 0.4);
  scene.lookAtGround();
}

void directionalAlongView(HardScene& scene)
{
  scene.addSolids();
  scene.addDirectionalLight(-2.5, -3.6, -6.5);
  scene.lookAtGround();
}

void directionalAgainstView(HardScene& scene)
{
  scene.addSolids();
  scene.addDirectionalLight(2.5, -0.6, 6.5);
  scene.look({2.5, 0.9, 6.5}, {0.0, 0.3, 0.0});
}

// The ground rises a little towards the eye, so the light behind the cube grazes it.
void directionalExactlyAgainstView(HardScene& scene)
{
  scene.addMesh(test::makeCube({0.0, -1.2, 0.0}, 1.0));
  scene.addPlate({-2.0, -2.0, -5.0}, {0.0, 1.15, 11.5}, {4.0, 0.0, 0.0});
  scene.addDirectionalLight(0.0, 0.0, 1.0);
  scene.look({0.0, 0.0, 8.0}, {0.0, 0.0, 0.0});
}

void directionalAlongFace(HardScene& scene)
{
  scene.addMesh(makeGridCube({0.0, 0.5, 0.0}, 1.0, 8));
  scene.addCube({-1.8, 0.0, 0.2}, 0.6);
  scene.addGround();
  scene.addPlate({2.0, 0.0, -2.0}, {0.0, 0.0, 4.0}, {0.0, 2.0, 0.0});
  scene.addDirectionalLight(1.0, 0.0, 0.0);
  scene.look({-2.5, 3.0, 6.5}, {0.0, 0.4, 0.0});
}

void directionalAlongFacesAndEdges(HardScene& scene)
{
  scene.addMesh(makeGridCube({0.0, 1.0, 0.0}, 1.0, 8));
  scene.addMesh(moved(upright(test::makeOpenCylinder(32)), {-2.2, 1.1, 0.0}));
  scene.addGround();
  scene.addDirectionalLight(0.0, -1.0, 0.0);
  scene.lookAtGround();
}

// Farther away than single precision keeps beside the scene.
void lightVeryFar(HardScene& scene)
{
  scene.addSolids();
  scene.addPointLight(-2.0e8, 5.0e8, 3.0e8);
  scene.lookAtGround();
}

void lightVeryNear(HardScene& scene)
{
  scene.addSolids();
  scene.addPointLight(-0.7, 1.00001, 0.3);
  scene.lookAtGround();
}

} // namespace

std::vector<HardCase> lightInViewCases()
{
  return {
      {"LightAtCamera", lightAtCamera, true, false},
      {"LightBehindCamera", lightBehindCamera},
      {"LightBetweenEyeAndNearPlane", lightBetweenEyeAndNearPlane},
      {"LightOnNearPlane", lightOnNearPlane},
      {"LightJustBeyondNearPlane", lightJustBeyondNearPlane},
      {"LightInView", lightInView},
      {"DirectionalAlongView", directionalAlongView},
      {"DirectionalAgainstView", directionalAgainstView},
      {"DirectionalExactlyAgainstView", directionalExactlyAgainstView},
      {"DirectionalAlongFace", directionalAlongFace},
      {"DirectionalAlongFacesAndEdges", directionalAlongFacesAndEdges},
      {"LightVeryFar", lightVeryFar},
      {"LightVeryNear", lightVeryNear},
  };
}

} // namespace shadow::robustness
