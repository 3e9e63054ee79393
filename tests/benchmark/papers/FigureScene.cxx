#include "FigureScene.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <vtkPlaneSource.h>
#include <vtkSphereSource.h>

namespace shadow::benchmarks
{

namespace
{

constexpr double fullTurn = 6.283185307179586;
constexpr double ring = 2.0; ///< radius of the ring that the objects stand in

} // namespace

FigureScene::FigureScene(const SceneSize& size) : scene(size.width, size.height)
{
  this->scene.pass->SetSavings(vtkShadowVolumePass::SAVINGS_NONE); // the papers' methods make all anew
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-1.7 * ring, 0.0, -1.7 * ring);
  floor->SetPoint1(-1.7 * ring, 0.0, 1.7 * ring);
  floor->SetPoint2(1.7 * ring, 0.0, -1.7 * ring);
  this->scene.addSource(floor);
  this->addObjects(size.objects, size.triangles - 2);
  this->scene.lookFrom(0.0, 0.8, 1.0, 0.95);
  for (int i = 0; i < size.lights; ++i)
  {
    this->lights.push_back(this->scene.addPointLight(0.0, 0.0, 0.0));
    this->lights.back()->SetIntensity(1.0 / size.lights);
  }
  this->moveLights(0);
}

void FigureScene::addObjects(int objects, int triangles)
{
  // A ball has 2 theta (phi - 2) triangles.
  const double wanted = static_cast<double>(triangles) / objects;
  const int theta = std::max(3, static_cast<int>(std::lround(std::sqrt(wanted / 2.0))));
  const int phi = std::max(3, 2 + static_cast<int>(std::lround(wanted / (2.0 * theta))));
  const double radius = std::min(0.5, 0.7 * ring * std::sin(0.5 * fullTurn / std::max(objects, 2)));
  for (int i = 0; i < objects; ++i)
  {
    const double angle = fullTurn * i / objects;
    vtkNew<vtkSphereSource> ball;
    ball->SetThetaResolution(theta);
    ball->SetPhiResolution(phi);
    ball->SetRadius(radius);
    ball->SetCenter(ring * std::cos(angle), 1.3 * radius, ring * std::sin(angle));
    this->scene.addSource(ball);
  }
}

void FigureScene::moveLights(int frame)
{
  for (std::size_t i = 0; i < this->lights.size(); ++i)
  {
    const double angle =
        fullTurn * static_cast<double>(i) / static_cast<double>(this->lights.size()) + 0.01 * frame;
    this->lights[i]->SetPosition(1.5 * ring * std::cos(angle), 2.0 * ring, 1.5 * ring * std::sin(angle));
  }
}

double FigureScene::draw()
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  this->scene.window->Render();
  this->scene.window->WaitForCompletion();
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

} // namespace shadow::benchmarks
