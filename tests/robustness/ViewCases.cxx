// How the view is projected, and into which part of what window.
#include <vtkCamera.h>
#include <vtkPerspectiveTransform.h>

#include "HardCase.h"
#include "HardScene.h"

namespace shadow::robustness
{

namespace
{

void addLitSolids(HardScene& scene)
{
  scene.addSolids();
  scene.addTwoLights();
  scene.lookAtGround();
}

vtkCamera* cameraOf(HardScene& scene)
{
  return scene.renderer->GetActiveCamera();
}

void makeParallel(HardScene& scene, double scale)
{
  cameraOf(scene)->ParallelProjectionOn();
  cameraOf(scene)->SetParallelScale(scale);
  scene.renderer->ResetCameraClippingRange();
}

void parallelProjection(HardScene& scene)
{
  addLitSolids(scene);
  makeParallel(scene, 2.2);
}

void parallelCameraInsideVolume(HardScene& scene)
{
  scene.addSolids();
  scene.addPlate({-1.0, 4.6, 4.0}, {5.0, 0.0, 0.0}, {0.0, 0.0, 3.0});
  scene.addPointLight(2.0, 9.0, 6.0);
  scene.addDirectionalLight(-0.1, -1.0, -0.2);
  scene.lookAtGround();
  makeParallel(scene, 2.2);
  cameraOf(scene)->SetClippingRange(1.0, 30.0);
}

void parallelNearPlaneCutsCasters(HardScene& scene)
{
  addLitSolids(scene);
  makeParallel(scene, 2.2);
  cameraOf(scene)->SetClippingRange(7.2, 30.0);
}

// Both ends of the clipping range around the eye, as only a parallel view can have it.
void parallelCameraInTheScene(HardScene& scene)
{
  scene.addSolids();
  scene.addTwoLights();
  scene.look({0.3, 0.6, 0.4}, {0.0, 0.4, 0.0});
  cameraOf(scene)->ParallelProjectionOn();
  cameraOf(scene)->SetParallelScale(2.2);
  cameraOf(scene)->SetClippingRange(0.01, 20.0);
}

void parallelLightAlongView(HardScene& scene)
{
  scene.addSolids();
  scene.addDirectionalLight(-2.5, -3.6, -6.5);
  scene.addPointLight(2.5, 4.0, 6.5);
  scene.lookAtGround();
  makeParallel(scene, 2.2);
}

// Looking straight down; the ground's depth is the same everywhere.
void parallelFromAbove(HardScene& scene)
{
  addLitSolids(scene);
  cameraOf(scene)->SetPosition(0.0, 5.0, 0.0);
  cameraOf(scene)->SetFocalPoint(0.0, 0.0, 0.0);
  cameraOf(scene)->SetViewUp(0.0, 0.0, -1.0);
  makeParallel(scene, 2.2);
}

void obliqueParallelProjection(HardScene& scene)
{
  addLitSolids(scene);
  makeParallel(scene, 2.2);
  cameraOf(scene)->SetViewShear(0.4, 0.3, 1.0);
}

void offCentreView(HardScene& scene)
{
  addLitSolids(scene);
  cameraOf(scene)->SetWindowCenter(0.6, -0.4);
}

void offCentreParallelView(HardScene& scene)
{
  addLitSolids(scene);
  makeParallel(scene, 2.2);
  cameraOf(scene)->SetWindowCenter(-0.5, 0.3);
}

void offCentreCameraInsideVolume(HardScene& scene)
{
  scene.addSolids();
  scene.addPlate({0.0, 3.0, 3.5}, {2.0, 0.0, 0.0}, {0.0, 0.0, 2.0});
  scene.addPointLight(1.2, 7.0, 4.0);
  scene.look({1.0, 1.5, 4.5}, {0.0, 0.3, 0.0}, 50.0);
  cameraOf(scene)->SetWindowCenter(0.7, 0.5);
}

void scaleView(HardScene& scene, double x, double y)
{
  vtkNew<vtkPerspectiveTransform> transform;
  transform->Scale(x, y, 1.0);
  cameraOf(scene)->SetUserTransform(transform);
}

void stretchedView(HardScene& scene)
{
  addLitSolids(scene);
  scaleView(scene, 0.5, 1.7);
}

void mirroredView(HardScene& scene)
{
  addLitSolids(scene);
  scaleView(scene, -1.0, 1.0);
}

void mirroredCameraInsideVolume(HardScene& scene)
{
  offCentreCameraInsideVolume(scene);
  scaleView(scene, -1.0, 1.0);
}

void obliqueView(HardScene& scene)
{
  addLitSolids(scene);
  cameraOf(scene)->SetObliqueAngles(60.0, 75.0);
}

void horizontalViewAngle(HardScene& scene)
{
  addLitSolids(scene);
  cameraOf(scene)->UseHorizontalViewAngleOn();
}

void wideAngle(HardScene& scene)
{
  addLitSolids(scene);
  scene.look({0.4, 1.5, 1.7}, {0.0, 0.4, 0.0}, 150.0);
}

void telephoto(HardScene& scene)
{
  addLitSolids(scene);
  scene.look({250.0, 400.0, 650.0}, {0.0, 0.4, 0.0}, 0.35);
}

void wideWindow(HardScene& scene)
{
  scene.window->SetSize(800, 150);
  addLitSolids(scene);
}

void tallWindow(HardScene& scene)
{
  scene.window->SetSize(151, 701);
  addLitSolids(scene);
}

void tinyWindow(HardScene& scene)
{
  scene.window->SetSize(17, 13);
  addLitSolids(scene);
}

void subViewport(HardScene& scene)
{
  scene.renderer->SetViewport(0.3, 0.15, 0.85, 0.95);
  addLitSolids(scene);
}

// Neither edge on a whole pixel.
void subViewportBetweenPixels(HardScene& scene)
{
  scene.window->SetSize(403, 307);
  scene.renderer->SetViewport(0.1234, 0.3333, 0.7777, 0.9191);
  addLitSolids(scene);
}

void parallelSubViewport(HardScene& scene)
{
  scene.renderer->SetViewport(0.5, 0.0, 1.0, 0.6);
  addLitSolids(scene);
  makeParallel(scene, 2.2);
}

void receiverFillsView(HardScene& scene)
{
  TriangleSoup triangle;
  triangle.points = {{-5000.0, 0.0, 4000.0}, {6000.0, 0.0, 5000.0}, {100.0, 0.0, -7000.0}};
  triangle.triangles = {{0, 1, 2}};
  scene.addMesh(triangle);
  scene.addCube({-0.9, 0.0, 0.2});
  scene.addMesh(moved(upright(test::makeTorus(0.7, 0.25, 48, 24)), {0.9, 0.9, 0.1}));
  scene.addTwoLights();
  scene.look({1.0, 6.0, 2.0}, {0.0, 0.0, 0.0});
  cameraOf(scene)->SetClippingRange(0.1, 100.0);
}

// One huge triangle in front of the camera, lit from behind: all of the view is in its shadow.
void casterFillsView(HardScene& scene)
{
  scene.addSolids();
  TriangleSoup triangle;
  triangle.points = {{-5000.0, -4000.0, 3.0}, {6000.0, -4000.0, 3.0}, {100.0, 7000.0, 3.0}};
  triangle.triangles = {{0, 1, 2}};
  scene.addMesh(triangle);
  scene.addPointLight(1.0, 2.0, -8.0);
  scene.look({0.0, 1.0, 6.0}, {0.0, 0.5, 0.0});
  cameraOf(scene)->SetClippingRange(0.1, 100.0);
}

// It hides the light from all that is seen, but is not seen itself.
void casterFillsViewOfLight(HardScene& scene)
{
  scene.addSolids();
  TriangleSoup triangle;
  triangle.points = {{-5000.0, 3.0, 4000.0}, {6000.0, 3.0, 4000.0}, {100.0, 3.0, -1.0}};
  triangle.triangles = {{0, 1, 2}};
  scene.addMesh(triangle);
  scene.addPointLight(1.0, 8.0, -1.0);
  scene.look({0.5, 2.0, 6.0}, {0.0, 0.5, 0.0});
  cameraOf(scene)->SetClippingRange(0.1, 100.0);
}

} // namespace

std::vector<HardCase> viewCases()
{
  return {
      {"ParallelProjection", parallelProjection},
      {"ParallelCameraInsideVolume", parallelCameraInsideVolume, false},
      {"ParallelNearPlaneCutsCasters", parallelNearPlaneCutsCasters, false},
      {"ParallelCameraInTheScene", parallelCameraInTheScene, false},
      {"ParallelLightAlongView", parallelLightAlongView, true, false},
      {"ParallelFromAbove", parallelFromAbove},
      {"ObliqueParallelProjection", obliqueParallelProjection},
      {"OffCentreView", offCentreView},
      {"OffCentreParallelView", offCentreParallelView},
      {"OffCentreCameraInsideVolume", offCentreCameraInsideVolume, false},
      {"StretchedView", stretchedView},
      {"MirroredView", mirroredView},
      {"MirroredCameraInsideVolume", mirroredCameraInsideVolume, false},
      {"ObliqueView", obliqueView},
      {"HorizontalViewAngle", horizontalViewAngle},
      {"WideAngle", wideAngle},
      {"Telephoto", telephoto},
      {"WideWindow", wideWindow},
      {"TallWindow", tallWindow},
      {"TinyWindow", tinyWindow, true, false},
      {"SubViewport", subViewport},
      {"SubViewportBetweenPixels", subViewportBetweenPixels},
      {"ParallelSubViewport", parallelSubViewport},
      {"ReceiverFillsView", receiverFillsView},
      {"CasterFillsView", casterFillsView, false, false},
      {"CasterFillsViewOfLight", casterFillsViewOfLight},
  };
}

} // namespace shadow::robustness
