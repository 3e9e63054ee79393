#include "ShadowScene.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <vtkAlgorithm.h>
#include <vtkCamera.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include "Pixels.h"
#include "SceneFromRenderer.h"

namespace shadow::truth
{

ShadowScene::ShadowScene(int width, int height)
{
  this->window->SetSize(width, height);
  this->window->AddRenderer(this->renderer);
  this->renderer->SetBackground(0.35, 0.45, 0.6);
  this->renderer->AutomaticLightCreationOff();
  this->renderer->SetPass(this->pass);
}

vtkActor* ShadowScene::addSource(vtkAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  return this->addMapper(mapper);
}

vtkActor* ShadowScene::addPolyData(vtkPolyData* polyData)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(polyData);
  return this->addMapper(mapper);
}

vtkActor* ShadowScene::addMapper(vtkMapper* mapper)
{
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.15);
  actor->GetProperty()->SetDiffuse(0.85);
  this->renderer->AddActor(actor);
  return actor;
}

vtkActor* ShadowScene::addFloor(double factor)
{
  std::array<double, 6> bounds{};
  this->renderer->ComputeVisiblePropBounds(bounds.data());
  const double x = 0.5 * (bounds[0] + bounds[1]);
  const double z = 0.5 * (bounds[4] + bounds[5]);
  const double height = std::max(bounds[3] - bounds[2], 1e-300);
  const double half = 0.5 * factor * std::max({bounds[1] - bounds[0], height, bounds[5] - bounds[4]});
  const double y = bounds[2] - 1e-3 * height;
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(x - half, y, z - half);
  plane->SetPoint1(x - half, y, z + half);
  plane->SetPoint2(x + half, y, z - half);
  return this->addSource(plane);
}

vtkLight* ShadowScene::addPointLight(double x, double y, double z)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPositional(true);
  light->SetConeAngle(180.0);
  light->SetPosition(x, y, z);
  this->renderer->AddLight(light);
  return light;
}

vtkLight* ShadowScene::addDirectionalLight(double dx, double dy, double dz)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPositional(false);
  light->SetPosition(-dx, -dy, -dz);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  this->renderer->AddLight(light);
  return light;
}

void ShadowScene::lookFrom(double dx, double dy, double dz, double distance)
{
  std::array<double, 6> bounds{};
  this->renderer->ComputeVisiblePropBounds(bounds.data());
  const glm::dvec3 lower(bounds[0], bounds[2], bounds[4]);
  const glm::dvec3 upper(bounds[1], bounds[3], bounds[5]);
  const glm::dvec3 centre = 0.5 * (lower + upper);
  const glm::dvec3 eye =
      centre + distance * glm::distance(lower, upper) * glm::normalize(glm::dvec3(dx, dy, dz));
  vtkCamera* camera = this->renderer->GetActiveCamera();
  camera->SetFocalPoint(centre.x, centre.y, centre.z);
  camera->SetPosition(eye.x, eye.y, eye.z);
  camera->SetViewUp(0.0, 1.0, 0.0);
  this->renderer->ResetCameraClippingRange();
}

std::vector<unsigned char> ShadowScene::renderMask(int light)
{
  this->window->Render();
  std::vector<unsigned char> mask = readMask(this->pass, light);
  if (mask.empty())
  {
    throw std::runtime_error("no shadow mask: " + this->pass->GetStatusMessage());
  }
  return mask;
}

std::vector<unsigned char> ShadowScene::renderPicture()
{
  this->window->Render();
  return readPicture(this->window);
}

MaskError ShadowScene::compare(int light, bool full)
{
  const std::vector<unsigned char> mask = this->renderMask(light);
  const SceneTruth truth = this->makeTruth(light);
  return compareMask(truth.mask(), mask, full);
}

MaskError ShadowScene::compare(const SceneTruth& truth, int light, bool full)
{
  return compareMask(truth.mask(), this->renderMask(light), full);
}

SceneTruth ShadowScene::makeTruth(int light)
{
  return SceneTruth(
      sceneFromRenderer(this->renderer, [this](vtkProp* prop) { return this->pass->GetCasting(prop); }),
      viewFromRenderer(this->renderer),
      lightsFromRenderer(this->renderer).at(static_cast<std::size_t>(light)).light);
}

} // namespace shadow::truth
