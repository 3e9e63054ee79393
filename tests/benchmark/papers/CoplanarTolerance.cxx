#include "CoplanarTolerance.h"

#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include <vtkOBJReader.h>

#include "FlatRegions.h"
#include "MeshFiles.h"
#include "ShadowScene.h"
#include "TestMeshes.h"

namespace shadow::benchmarks
{

namespace
{

using truth::MaskError;
using truth::SceneTruth;
using truth::ShadowScene;

constexpr int lights = 4;

/// A model on a floor, with a point light at one of several places above it.
class ModelScene
{
public:
  ModelScene(const std::string& file, int light) : scene(640, 480)
  {
    vtkNew<vtkOBJReader> reader;
    reader->SetFileName(file.c_str());
    vtkActor* actor = this->scene.addSource(reader);
    const double* centre = actor->GetCenter();
    const double size = actor->GetLength();
    const double angle = 0.4 + 6.283185307179586 * light / lights;
    this->scene.addPointLight(centre[0] + size * std::cos(angle), centre[1] + 1.1 * size,
                              centre[2] + size * std::sin(angle));
    this->scene.lookFrom(0.4, 0.5, 1.0, 1.9);
    this->scene.addFloor();
    this->scene.renderer->ResetCameraClippingRange();
    this->scene.pass->SetSilhouetteMethod(vtkShadowVolumePass::SILHOUETTE_HYBRID);
    this->scene.window->Render();
    this->truth.reset(new SceneTruth(this->scene.makeTruth())); // cannot be moved
  }

  ShadowScene scene;
  std::unique_ptr<SceneTruth> truth;
};

/// Truth is cast once a model, not once a tolerance.
std::vector<std::unique_ptr<ModelScene>>& scenesOf(const std::string& file)
{
  static std::string current;
  static std::vector<std::unique_ptr<ModelScene>> scenes;
  if (file != current)
  {
    scenes.clear();
    for (int light = 0; light < lights; ++light)
    {
      scenes.push_back(std::make_unique<ModelScene>(file, light));
    }
    current = file;
  }
  return scenes;
}

void wrongPixels(benchmark::State& state, const std::string& file, double tolerance)
{
  const SEDGeometry geometry = test::build(test::readMeshFile(file));
  for (auto _ : state)
  {
    std::size_t wrong = 0;
    std::size_t pixels = 0;
    double edges = 0.0;
    for (const std::unique_ptr<ModelScene>& model : scenesOf(file))
    {
      model->scene.pass->SetCoplanarTolerance(tolerance);
      const MaskError error = model->scene.compare(*model->truth, 0, true);
      wrong += error.wrongCertain;
      pixels += error.certain;
      edges += static_cast<double>(model->scene.pass->GetSilhouetteEdges());
    }
    state.counters["wrong_certain_per_million"] =
        1e6 * static_cast<double>(wrong) / static_cast<double>(pixels);
    state.counters["silhouette_edges"] = edges / lights;
  }
  state.counters["triangles"] = static_cast<double>(geometry.getTriangles().size());
  state.counters["flat_regions"] = static_cast<double>(findFlatRegions(geometry, tolerance).getRegionCount());
}

} // namespace

void registerCoplanarTolerance(const std::string& modelFolder)
{
  for (const char* name : {"fandisk", "spot", "rocker-arm", "stanford-bunny"})
  {
    const std::string file = modelFolder + "/" + name + ".obj";
    if (!std::filesystem::exists(file))
    {
      continue;
    }
    for (const char* degrees : {"0", "0.01", "0.1", "1", "5", "20"})
    {
      const double tolerance = std::stod(degrees);
      benchmark::RegisterBenchmark(("CoplanarTolerance/" + std::string(name) + "/" + degrees).c_str(),
                                   [file, tolerance](auto& state) { wrongPixels(state, file, tolerance); })
          ->Iterations(1)
          ->Unit(benchmark::kMillisecond);
    }
  }
}

} // namespace shadow::benchmarks
