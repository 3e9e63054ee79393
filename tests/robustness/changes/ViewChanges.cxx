// What happens to cameras, windows, renderers and the pass.
#include "Changes.h"

#include <vtkCamera.h>

namespace shadow::fuzz
{

namespace
{

using Pass = vtkShadowVolumePass;

void changeCamera(ChangingScene& scene, FuzzRandom& random)
{
  vtkCamera* camera = scene.renderer->GetActiveCamera();
  switch (random.below(6))
  {
  case 0:
    camera->Azimuth(random.between(-30.0, 30.0));
    break;
  case 1:
    camera->Dolly(random.between(0.8, 1.25));
    break;
  case 2:
    camera->SetParallelProjection(random.chance(0.4));
    break;
  case 3:
    camera->SetClippingRange(random.between(0.05, 2.0), random.between(20.0, 60.0));
    break;
  case 4:
    camera->SetViewAngle(random.between(20.0, 60.0));
    break;
  default:
    scene.renderer->ResetCameraClippingRange();
  }
}

void changeSetting(ChangingScene& scene, FuzzRandom& random)
{
  switch (random.below(8))
  {
  case 0:
    scene.pass->SetSilhouetteMethod(random.integer(0, Pass::SILHOUETTE_COMPUTE));
    break;
  case 1:
    scene.pass->SetStencilMethod(random.chance(0.5) ? Pass::STENCIL_AUTO : Pass::STENCIL_ZFAIL);
    break;
  case 2:
    scene.pass->SetCountBuffer(random.integer(0, Pass::COUNT_COLOR));
    break;
  case 3:
    scene.pass->SetCompositing(random.integer(0, Pass::COMPOSITING_ADDITIVE));
    break;
  case 4:
    scene.pass->SetSamples(random.chance(0.6) ? 1 : 4);
    break;
  case 5:
    scene.pass->SetShadowIntensity(random.real());
    break;
  case 6:
    scene.pass->SetCoplanarTolerance(random.chance(0.7) ? 0.0 : 20.0);
    break;
  default:
    scene.pass->SetWeldTolerance(random.chance(0.7) ? 0.0 : 0.05);
  }
}

void release(ChangingScene& scene, FuzzRandom& random)
{
  if (random.chance(0.7))
  {
    scene.pass->ReleaseGraphicsResources(scene.window);
  }
  else
  {
    scene.window->Finalize();
  }
}

/// Draws without the pass, with or without a change meanwhile.
void takeOff(ChangingScene& scene, FuzzRandom& random)
{
  scene.renderer->SetPass(nullptr);
  if (random.chance(0.5))
  {
    scene.pickActor(random).actor->SetPosition(random.real(), random.real(), random.real());
  }
  scene.window->Render();
  scene.renderer->SetPass(scene.pass);
}

} // namespace

std::vector<Change> listViewChanges()
{
  return {{"nothing", [](ChangingScene&, FuzzRandom&) {}},
          {"camera", changeCamera},
          {"camera", changeCamera},
          {"window's size",
           [](ChangingScene& s, FuzzRandom& r) { s.window->SetSize(r.integer(50, 80), r.integer(40, 60)); }},
          {"window's size in the same shape",
           [](ChangingScene& s, FuzzRandom& r)
           {
             const int scale = r.integer(9, 20);
             s.window->SetSize(4 * scale, 3 * scale);
           }},
          {"viewport",
           [](ChangingScene& s, FuzzRandom& r)
           { s.renderer->SetViewport(r.between(0.0, 0.2), 0.0, r.between(0.4, 0.5), r.between(0.6, 1.0)); }},
          {"second renderer", [](ChangingScene& s, FuzzRandom& r) { s.setSecond(r.chance(0.4)); }},
          {"setting", changeSetting},
          {"setting", changeSetting},
          {"savings",
           [](ChangingScene& s, FuzzRandom& r) { s.pass->SetSavings(r.chance(0.8) ? Pass::SAVINGS_ALL : 0); }},
          {"resources released", release},
          {"pass off and on", takeOff}};
}

} // namespace shadow::fuzz
