// Scenes about lights and cameras.

#include <vtkCamera.h>

#include "ImageScenes.h"

namespace shadow::test
{

void makePointLight(truth::ShadowScene& scene)
{
  const StillLife stillLife(scene);
  scene.addPointLight(-2.0, 3.5, 2.0);
}

void makeDirectionalLight(truth::ShadowScene& scene)
{
  const StillLife stillLife(scene);
  scene.addDirectionalLight(1.0, -1.0, -0.4);
}

void makeSpotLight(truth::ShadowScene& scene)
{
  const StillLife stillLife(scene);
  vtkLight* light = scene.addPointLight(-1.0, 3.6, 1.4);
  light->SetFocalPoint(0.1, 0.0, 0.0);
  light->SetConeAngle(40.0);
}

void makeTwoLights(truth::ShadowScene& scene)
{
  const StillLife stillLife(scene);
  scene.addPointLight(-2.0, 3.5, 2.0)->SetColor(1.0, 0.55, 0.35);
  scene.addPointLight(2.4, 3.0, 1.2)->SetColor(0.3, 0.5, 0.9);
}

void makeCameraInsideVolume(truth::ShadowScene& scene)
{
  // The eye is in the ring's shadow, and looks through the ring's hole.
  const StillLife stillLife(scene);
  scene.addPointLight(-0.9, 0.9, -4.0);
  vtkCamera* camera = scene.renderer->GetActiveCamera();
  camera->SetPosition(-0.7, 1.75, 2.2);
  camera->SetFocalPoint(0.2, 0.1, -0.2);
  camera->SetViewAngle(50.0);
  scene.renderer->ResetCameraClippingRange();
}

void makeParallelProjection(truth::ShadowScene& scene)
{
  const StillLife stillLife(scene);
  scene.addPointLight(-2.0, 3.5, 2.0);
  scene.renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.renderer->GetActiveCamera()->SetParallelScale(1.9);
  scene.renderer->ResetCameraClippingRange();
}

} // namespace shadow::test
