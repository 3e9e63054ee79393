#include "FirstFrames.h"

#include <cmath>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include <vtkSphereSource.h>

#include "ShadowScene.h"
#include "Timing.h"

namespace shadow::benchmarks
{

namespace
{

/// Spheres on a square grid above a floor, a point light above them.
void fill(truth::ShadowScene& scene, int meshes, int triangles)
{
  const int row = static_cast<int>(std::ceil(std::sqrt(meshes)));
  const int side = static_cast<int>(std::sqrt(triangles / 2.0));
  for (int mesh = 0; mesh < meshes; ++mesh)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetCenter(mesh % row, 0.0, mesh / row);
    sphere->SetRadius(0.4);
    sphere->SetThetaResolution(side);
    sphere->SetPhiResolution(side);
    sphere->Update();
    scene.addSource(sphere);
  }
  scene.addFloor(1.5);
  scene.lookFrom(-0.4, 0.7, 1.0, 1.0);
  scene.addPointLight(0.6 * row, 1.0 * row, 0.4 * row);
}

/// A window of its own for each, so that nothing is taken over.
double drawFirst(int meshes, int triangles, bool shadows, double& sceneMilliseconds)
{
  truth::ShadowScene scene(640, 480);
  fill(scene, meshes, triangles);
  scene.pass->MeasureStagesOn();
  scene.renderer->SetPass(shadows ? scene.pass.Get() : nullptr);
  const double milliseconds = measure(
      [&scene]
      {
        scene.window->Render();
        scene.window->WaitForCompletion();
      });
  sceneMilliseconds = scene.pass->GetSceneMilliseconds();
  return milliseconds;
}

void firstFrame(benchmark::State& state, int meshes, int triangles)
{
  std::vector<double> plain;
  std::vector<double> shadowed;
  std::vector<double> mirroring;
  double milliseconds = 0.0;
  for (auto _ : state)
  {
    plain.push_back(drawFirst(meshes, triangles, false, milliseconds));
    shadowed.push_back(drawFirst(meshes, triangles, true, milliseconds));
    mirroring.push_back(milliseconds);
    state.SetIterationTime(1e-3 * shadowed.back());
  }
  state.counters["plain_ms"] = median(plain);
  state.counters["first_ms"] = median(shadowed);
  state.counters["scene_ms"] = median(mirroring);
  state.counters["first_over_plain"] = median(shadowed) / median(plain);
}

} // namespace

void registerFirstFrames()
{
  for (const int meshes : {1, 500})
  {
    const std::string name = "FirstFrame/spheres-" + std::to_string(meshes) + "/" + std::to_string(5000000 / meshes);
    benchmark::RegisterBenchmark(name.c_str(), firstFrame, meshes, 5000000 / meshes)
        ->UseManualTime()
        ->Iterations(5)
        ->Unit(benchmark::kMillisecond);
  }
}

} // namespace shadow::benchmarks
