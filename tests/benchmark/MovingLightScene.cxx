#include "MovingLightScene.h"

#include <algorithm>
#include <cmath>

#include <vtkCamera.h>

#include "ShadowMap.h"
#include "Timing.h"

namespace shadow::benchmarks
{

MovingLightScene::MovingLightScene(vtkAlgorithm* source) : scene(640, 480)
{
  vtkActor* actor = this->scene.addSource(source);
  std::copy_n(actor->GetBounds(), 6, this->bounds);
  this->diagonal = actor->GetLength();
  this->scene.addFloor();
  this->scene.lookFrom(-0.4, 0.7, 1.0, 1.0);
  this->light = this->scene.addPointLight(0.0, 0.0, 0.0);
  // A shadow map knows spot lights below 90 degrees only.
  this->light->SetConeAngle(89.0);
  this->light->SetFocalPoint(this->centre(0), this->centre(2), this->centre(4));
  this->moveLight();

  useShadowMap(this->shadowMap);
}

MovingLightScene::~MovingLightScene()
{
  this->shadowMap->ReleaseGraphicsResources(this->scene.window);
  this->scene.renderer->SetPass(nullptr);
}

double MovingLightScene::draw(vtkRenderPass* pass)
{
  if (this->scene.renderer->GetPass() != pass)
  {
    this->scene.renderer->SetPass(pass);
  }
  this->moveLight();
  if (this->cameraMoves)
  {
    this->scene.renderer->GetActiveCamera()->Azimuth(0.3);
  }
  return measure(
      [this]
      {
        this->scene.window->Render();
        this->scene.window->WaitForCompletion();
      });
}

void MovingLightScene::moveLight()
{
  this->angle += 0.01;
  this->light->SetPosition(this->centre(0) + 0.6 * this->diagonal * std::cos(this->angle),
                           this->bounds[3] + 0.8 * this->diagonal,
                           this->centre(4) + 0.6 * this->diagonal * std::sin(this->angle));
}

} // namespace shadow::benchmarks
