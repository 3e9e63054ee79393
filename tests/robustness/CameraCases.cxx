// Where the camera and its near plane are.
#include <vtkCamera.h>

#include "HardCase.h"
#include "HardScene.h"

namespace shadow::robustness
{

namespace
{

const glm::dvec3 eyeAboveGround(1.0, 1.5, 4.5);

void addSolids(HardScene& scene)
{
  scene.addCube({-0.9, 0.0, 0.2});
  scene.addMesh(moved(upright(test::makeTorus(0.7, 0.25, 48, 24)), {0.9, 0.9, 0.1}));
  scene.addGround(6.0);
}

void lookFromEye(HardScene& scene, double nearDistance)
{
  scene.look(eyeAboveGround, {0.0, 0.3, 0.0}, 50.0);
  scene.renderer->GetActiveCamera()->SetClippingRange(nearDistance, 50.0);
}

void cameraInsideVolume(HardScene& scene)
{
  addSolids(scene);
  scene.addPlate({0.0, 3.0, 3.5}, {2.0, 0.0, 0.0}, {0.0, 0.0, 2.0});
  scene.addPointLight(1.2, 7.0, 4.0);
  scene.addDirectionalLight(0.1, -1.0, -0.05);
  lookFromEye(scene, 0.1);
}

void cameraInsideVolumeOfClosedMesh(HardScene& scene)
{
  addSolids(scene);
  scene.addMesh(moved(test::makeSphere(0.8, 32, 16), {1.1, 3.0, 4.3}));
  scene.addPointLight(1.2, 7.0, 4.0);
  scene.addDirectionalLight(0.1, -1.0, -0.05);
  lookFromEye(scene, 0.1);
}

void cameraInsideSeveralVolumes(HardScene& scene)
{
  addSolids(scene);
  for (int i = 0; i < 5; ++i)
  {
    scene.addPlate({-0.5 + 0.1 * i, 2.5 + 0.3 * i, 3.0}, {2.0, 0.1 * i, 0.0}, {0.0, 0.0, 2.5});
  }
  scene.addMesh(moved(test::makeCubesSharingAnEdge(), {1.0, 5.5, 4.5}));
  scene.addPointLight(1.2, 9.0, 4.0);
  lookFromEye(scene, 0.1);
}

// The whole volume, caps and all, is around the eye: seen from inside the shadow, at the caster's dark side.
void cameraUnderDome(HardScene& scene)
{
  scene.addMesh(moved(makeDome(2.5, 48), {1.0, 0.6, 4.0}));
  addSolids(scene);
  scene.addPointLight(0.0, 6.0, 6.0);
  lookFromEye(scene, 0.1);
}

// A side of the volume crosses the near rectangle, which is large.
void nearPlaneCutsVolume(HardScene& scene)
{
  addSolids(scene);
  scene.addPlate({0.9, 3.0, 2.0}, {3.0, 0.0, 0.0}, {0.0, 0.0, 3.0});
  scene.addPointLight(1.0, 8.0, 3.5);
  scene.addDirectionalLight(0.02, -1.0, 0.01);
  lookFromEye(scene, 1.0);
}

void nearPlaneCutsCaster(HardScene& scene)
{
  addSolids(scene);
  const glm::dvec3 way = glm::normalize(glm::dvec3(0.0, 0.3, 0.0) - eyeAboveGround);
  const glm::dvec3 cut = eyeAboveGround + 1.5 * way;
  scene.addMesh(moved(test::makeSphere(0.35, 32, 16), cut + glm::dvec3(0.5, 0.1, 0.0)));
  scene.addMesh(moved(upright(test::makeTorus(0.3, 0.1, 32, 16)), cut - glm::dvec3(0.5, 0.0, 0.0)));
  scene.addPointLight(2.0, 5.0, 5.0);
  scene.addDirectionalLight(-0.4, -0.6, -0.5);
  lookFromEye(scene, 1.5);
}

void nearPlaneCutsOpenCaster(HardScene& scene)
{
  addSolids(scene);
  const glm::dvec3 way = glm::normalize(glm::dvec3(0.0, 0.3, 0.0) - eyeAboveGround);
  scene.addPlate(eyeAboveGround + 0.8 * way - glm::dvec3(0.2, 0.2, 0.0), {0.6, 0.05, 0.0}, 1.2 * way);
  scene.addPointLight(2.0, 5.0, 5.0);
  lookFromEye(scene, 1.5);
}

// The near plane takes away all of it; its shadow stays.
void casterBetweenEyeAndNearPlane(HardScene& scene)
{
  addSolids(scene);
  const glm::dvec3 way = glm::normalize(glm::dvec3(0.0, 0.3, 0.0) - eyeAboveGround);
  scene.addMesh(moved(test::makeSphere(0.2, 32, 16), eyeAboveGround + 0.8 * way));
  scene.addPointLight(1.8, 3.5, 7.0);
  lookFromEye(scene, 1.5);
}

void casterBehindCamera(HardScene& scene)
{
  addSolids(scene);
  scene.addPlate({-3.0, 1.0, 6.0}, {4.0, 0.0, 0.0}, {0.0, 2.0, 0.0});
  scene.addDirectionalLight(0.3, -0.5, -1.0);
  scene.addPointLight(-2.0, 3.5, 9.0);
  lookFromEye(scene, 0.1);
}

void cameraInsideClosedCaster(HardScene& scene)
{
  addSolids(scene);
  scene.addMesh(moved(test::makeSphere(1.0, 32, 16), eyeAboveGround + glm::dvec3(0.2, 0.1, 0.3)));
  scene.addPointLight(1.2, 7.0, 4.0);
  lookFromEye(scene, 0.1);
}

// The near plane reaches out of the caster: what is seen through the hole is right, too.
void nearPlaneLeavesCasterAroundCamera(HardScene& scene)
{
  addSolids(scene);
  scene.addMesh(moved(test::makeSphere(1.0, 32, 16), eyeAboveGround + glm::dvec3(0.2, 0.1, 0.3)));
  scene.addPointLight(1.2, 7.0, 4.0);
  lookFromEye(scene, 0.6);
}

void farPlaneCutsScene(HardScene& scene)
{
  addSolids(scene);
  scene.addPointLight(-2.0, 4.0, 2.0);
  lookFromEye(scene, 0.1);
  scene.renderer->GetActiveCamera()->SetClippingRange(0.1, 4.5);
}

void nearPlaneVeryNear(HardScene& scene)
{
  addSolids(scene);
  scene.addTwoLights();
  lookFromEye(scene, 1e-6);
}

// Exactly at the height of the plate and of the cube's top.
void cameraInPlaneOfCasters(HardScene& scene)
{
  scene.addCube({-0.9, 0.0, 0.2});
  scene.addPlate({0.2, 1.0, -0.5}, {1.5, 0.0, 0.0}, {0.0, 0.0, 1.0});
  scene.addGround();
  scene.addTwoLights();
  scene.look({0.5, 1.0, 5.0}, {0.0, 1.0, 0.0}, 45.0);
}

} // namespace

std::vector<HardCase> cameraCases()
{
  return {
      {"CameraInsideVolume", cameraInsideVolume, false},
      {"CameraInsideVolumeOfClosedMesh", cameraInsideVolumeOfClosedMesh, false},
      {"CameraInsideSeveralVolumes", cameraInsideSeveralVolumes, false},
      {"CameraUnderDome", cameraUnderDome, false},
      {"NearPlaneCutsVolume", nearPlaneCutsVolume, false},
      {"NearPlaneCutsCaster", nearPlaneCutsCaster, false},
      {"NearPlaneCutsOpenCaster", nearPlaneCutsOpenCaster, false},
      {"CasterBetweenEyeAndNearPlane", casterBetweenEyeAndNearPlane, false},
      {"CasterBehindCamera", casterBehindCamera, false},
      {"CameraInsideClosedCaster", cameraInsideClosedCaster, false, false},
      {"NearPlaneLeavesCasterAroundCamera", nearPlaneLeavesCasterAroundCamera, false},
      {"FarPlaneCutsScene", farPlaneCutsScene},
      {"NearPlaneVeryNear", nearPlaneVeryNear},
      {"CameraInPlaneOfCasters", cameraInPlaneOfCasters},
  };
}

} // namespace shadow::robustness
