#include "ImageScenes.h"

#include <vtkCamera.h>
#include <vtkConeSource.h>
#include <vtkCubeSource.h>
#include <vtkPlaneSource.h>
#include <vtkProperty.h>
#include <vtkSuperquadricSource.h>

namespace shadow::test
{

const std::map<std::string, MakeScene>& imageScenes()
{
  static const std::map<std::string, MakeScene> scenes = {
      {"PointLight_OnFloor", makePointLight},
      {"DirectionalLight_Slanting", makeDirectionalLight},
      {"SpotLight_Cone40", makeSpotLight},
      {"TwoLights_Coloured", makeTwoLights},
      {"PointLight_CameraInsideVolume", makeCameraInsideVolume},
      {"ParallelProjection", makeParallelProjection},
      {"Additive_TwoLights", makeAdditive},
      {"PhysicallyBased_Directional", makePhysicallyBased},
      {"SmoothTexturedAndScalars", makeSmoothTexturedAndScalars},
      {"TranslucentAndOverlay", makeTranslucentAndOverlay},
      {"TwoViewports", makeTwoViewports},
      {"Samples4_SmoothEdges", makeSamples},
      {"Outlines_CreasesAndHiddenOverShadows", makeOutlinesOverShadows},
  };
  return scenes;
}

StillLife::StillLife(truth::ShadowScene& scene)
{
  vtkNew<vtkSuperquadricSource> ringSource;
  ringSource->ToroidalOn();
  ringSource->SetThickness(0.35);
  ringSource->SetThetaResolution(40);
  ringSource->SetPhiResolution(24);
  ringSource->SetSize(0.8);
  this->ring = scene.addSource(ringSource);
  this->ring->RotateX(75.0);
  this->ring->SetPosition(-0.7, 0.82, 0.0);
  this->ring->GetProperty()->SetColor(0.95, 0.75, 0.3);

  vtkNew<vtkCubeSource> blockSource;
  blockSource->SetXLength(0.6);
  blockSource->SetYLength(0.9);
  blockSource->SetZLength(0.6);
  this->block = scene.addSource(blockSource);
  this->block->SetPosition(0.7, 0.45, -0.4);
  this->block->RotateY(30.0);
  this->block->GetProperty()->SetColor(0.45, 0.65, 0.9);

  vtkNew<vtkConeSource> coneSource;
  coneSource->SetDirection(0.0, 1.0, 0.0);
  coneSource->SetHeight(0.8);
  coneSource->SetRadius(0.35);
  coneSource->SetResolution(24);
  this->cone = scene.addSource(coneSource);
  this->cone->SetPosition(0.9, 0.4, 0.8);
  this->cone->GetProperty()->SetColor(0.85, 0.4, 0.4);

  vtkNew<vtkPlaneSource> floorSource;
  floorSource->SetOrigin(-3.0, 0.0, 3.0);
  floorSource->SetPoint1(3.0, 0.0, 3.0);
  floorSource->SetPoint2(-3.0, 0.0, -3.0);
  this->floor = scene.addSource(floorSource);

  vtkCamera* camera = scene.renderer->GetActiveCamera();
  camera->SetPosition(0.8, 2.6, 5.4);
  camera->SetFocalPoint(0.1, 0.4, 0.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  scene.renderer->ResetCameraClippingRange();
}

} // namespace shadow::test
