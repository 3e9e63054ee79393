#include "SavingsScene.h"

#include <algorithm>
#include <cmath>

#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkPolyDataMapper.h>
#include <vtkSphereSource.h>

#include "ShadowMap.h"
#include "Timing.h"

namespace shadow::benchmarks
{

namespace
{

int rowOf(int objects)
{
  return std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(objects)))));
}

} // namespace

SavingsScene::SavingsScene(const SavingsSceneSize& sceneSize, int width, int height) : scene(width, height)
{
  switch (sceneSize.kind)
  {
    case SavingsSceneSize::Kind::Tori:
      this->addTori(sceneSize);
      break;
    case SavingsSceneSize::Kind::Spheres:
      this->addSpheres(sceneSize);
      break;
    case SavingsSceneSize::Kind::City:
      this->addCity(sceneSize);
      break;
  }
  double bounds[6];
  this->scene.renderer->ComputeVisiblePropBounds(bounds);
  const glm::dvec3 lower(bounds[0], bounds[2], bounds[4]);
  const glm::dvec3 upper(bounds[1], bounds[3], bounds[5]);
  this->size = glm::distance(lower, upper);
  this->centre = 0.5 * (lower + upper);
  this->scene.addFloor(sceneSize.objects > 1 ? 1.2 : 3.0);
  this->addLights(sceneSize.lights);
  this->look(sceneSize.eye);
  useShadowMap(this->shadowMap);
}

SavingsScene::~SavingsScene()
{
  this->shadowMap->ReleaseGraphicsResources(this->scene.window);
  this->scene.renderer->SetPass(nullptr);
}

void SavingsScene::place(vtkActor* placed, int number, int objects, double distance) const
{
  const int row = rowOf(objects);
  placed->SetPosition(distance * (number % row), 0.6, distance * (number / row));
}

void SavingsScene::addTori(const SavingsSceneSize& sceneSize)
{
  // A torus has 2 u v triangles.
  const int v = std::max(3, static_cast<int>(std::lround(std::sqrt(sceneSize.triangles / 4.0))));
  for (int i = 0; i < sceneSize.objects; ++i)
  {
    vtkNew<vtkParametricTorus> torus;
    torus->SetRingRadius(0.4);
    torus->SetCrossSectionRadius(0.15);
    vtkNew<vtkParametricFunctionSource> source;
    source->SetParametricFunction(torus);
    source->SetUResolution(2 * v);
    source->SetVResolution(v);
    this->actor = this->scene.addSource(source);
    this->actor->RotateX(70.0);
    this->place(this->actor, i, sceneSize.objects, 1.2);
  }
}

void SavingsScene::addSpheres(const SavingsSceneSize& sceneSize)
{
  // A sphere has 2 theta (phi - 2) triangles.
  const int theta = std::max(3, static_cast<int>(std::lround(std::sqrt(sceneSize.triangles / 2.0))));
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.45);
  sphere->SetThetaResolution(theta);
  sphere->SetPhiResolution(std::max(3, 2 + sceneSize.triangles / (2 * theta)));
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  for (int i = 0; i < sceneSize.objects; ++i)
  {
    this->actor = this->scene.addMapper(mapper);
    this->place(this->actor, i, sceneSize.objects, 1.2);
  }
}

void SavingsScene::addCity(const SavingsSceneSize& sceneSize)
{
  const int row = rowOf(sceneSize.objects);
  for (int i = 0; i < sceneSize.objects; ++i)
  {
    const double height = 0.6 + 2.4 * std::abs(std::sin(12.9898 * i));
    vtkNew<vtkCubeSource> box;
    box->SetYLength(height);
    box->SetCenter(1.6 * (i % row), 0.5 * height, 1.6 * (i / row));
    this->actor = this->scene.addSource(box);
  }
}

void SavingsScene::addLights(int count)
{
  for (int i = 0; i < count; ++i)
  {
    const double angle = 6.283185307179586 * i / count;
    this->light = this->scene.addPointLight(this->centre.x + 0.35 * this->size * std::cos(angle),
                                            this->centre.y + 0.9 * this->size,
                                            this->centre.z + 0.35 * this->size * std::sin(angle));
    this->light->SetFocalPoint(this->centre.x, this->centre.y, this->centre.z);
    // A shadow map knows spot lights below 90 degrees only.
    this->light->SetConeAngle(89.0);
    this->light->SetIntensity(1.0 / count);
  }
}

void SavingsScene::look(SavingsSceneSize::Eye eye)
{
  this->scene.lookFrom(-0.4, 0.7, 1.0, eye == SavingsSceneSize::Eye::Far ? 4.0 : 0.8);
  if (eye == SavingsSceneSize::Eye::Street)
  {
    vtkCamera* camera = this->scene.renderer->GetActiveCamera();
    camera->SetPosition(this->centre.x + 0.8, 0.9, this->centre.z);
    camera->SetFocalPoint(this->centre.x + 0.8, 0.9, this->centre.z - 1.0);
    camera->SetViewAngle(60.0);
  }
  this->scene.renderer->ResetCameraClippingRange();
}

void SavingsScene::move(Moves moves)
{
  this->frame += 1;
  // To and fro, so that a long run stays where it is.
  const double step = (this->frame / 40) % 2 == 0 ? 1.0 : -1.0;
  if (moves == Moves::Camera)
  {
    this->scene.renderer->GetActiveCamera()->Yaw(0.2 * step);
    this->scene.renderer->ResetCameraClippingRange();
  }
  else if (moves == Moves::Light)
  {
    double position[3];
    this->light->GetPosition(position);
    this->light->SetPosition(position[0] + 0.003 * this->size * step, position[1], position[2]);
  }
  else if (moves == Moves::Actor)
  {
    this->actor->AddPosition(0.01 * step, 0.0, 0.0);
  }
}

double SavingsScene::draw(vtkRenderPass* pass, Moves moves)
{
  this->scene.renderer->SetPass(pass);
  this->scene.window->Render();
  this->move(moves);
  return measure(
      [this]
      {
        this->scene.window->Render();
        this->scene.window->WaitForCompletion();
      });
}

} // namespace shadow::benchmarks
