// Frames with one moving point light, and a camera that stands still or moves, too: plain VTK,
// vtkShadowMapPass at 2048 x 2048, and shadow volumes, in turns, so that their ratio means something on a
// noisy machine. And the memory a frame takes, and what a pass saves that keeps what has not changed.
//
//   bench_frame [MODEL.obj...] [--benchmark_...]   without models: built-in ones, and the meshes found beside
//   the project

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include <vtkOBJReader.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>
#include <vtkTrivialProducer.h>

#include "FirstFrames.h"
#include "MovingLightScene.h"
#include "SilhouetteFinder.h"
#include "Timing.h"

namespace
{

using shadow::benchmarks::median;
using shadow::benchmarks::MovingLightScene;

vtkSmartPointer<vtkAlgorithm> makeSource(const std::string& model)
{
  if (model.rfind("sphere-", 0) == 0)
  {
    // About n triangles: 2 theta phi.
    const int side = static_cast<int>(std::sqrt(std::stod(model.substr(7)) / 2.0));
    auto sphere = vtkSmartPointer<vtkSphereSource>::New();
    sphere->SetThetaResolution(side);
    sphere->SetPhiResolution(side);
    return sphere;
  }
  auto reader = vtkSmartPointer<vtkOBJReader>::New();
  reader->SetFileName(model.c_str());
  return reader;
}

void frameAgainstShadowMap(benchmark::State& state, const std::string& model, bool cameraMoves)
{
  MovingLightScene moving(makeSource(model));
  moving.cameraMoves = cameraMoves;
  vtkRenderPass* const passes[] = {nullptr, moving.shadowMap, moving.scene.pass};
  std::vector<double> milliseconds[3];
  for (auto _ : state)
  {
    for (int i = 0; i < 3; ++i)
    {
      // A pass that was just attached has VTK build its shaders again; its second frame counts.
      moving.draw(passes[i]);
      milliseconds[i].push_back(moving.draw(passes[i]));
    }
    state.SetIterationTime(1e-3 * milliseconds[2].back());
  }
  state.counters["plain_ms"] = median(milliseconds[0]);
  state.counters["shadow_map_ms"] = median(milliseconds[1]);
  state.counters["volumes_ms"] = median(milliseconds[2]);
  state.counters["volumes_over_map"] = median(milliseconds[2]) / median(milliseconds[1]);
  state.counters["hidden_backs"] = moving.scene.pass->GetNumberOfHiddenBacks();
  state.counters["triangles"] = static_cast<double>(moving.scene.pass->GetAmbientTriangles());
}

void stages(benchmark::State& state, const std::string& model, int stencilMethod)
{
  MovingLightScene moving(makeSource(model));
  vtkShadowVolumePass* pass = moving.scene.pass;
  pass->SetStencilMethod(stencilMethod);
  pass->MeasureStagesOn();
  moving.draw(pass);
  std::vector<double> silhouette;
  std::vector<double> prePass;
  std::vector<double> stencil;
  std::vector<double> lighting;
  for (auto _ : state)
  {
    state.SetIterationTime(1e-3 * moving.draw(pass));
    silhouette.push_back(pass->GetSilhouetteMilliseconds());
    prePass.push_back(pass->GetPrePassMilliseconds());
    stencil.push_back(pass->GetStencilMilliseconds());
    lighting.push_back(pass->GetLightingMilliseconds());
  }
  state.counters["silhouette_ms"] = median(silhouette);
  state.counters["prepass_ms"] = median(prePass);
  state.counters["stencil_ms"] = median(stencil);
  state.counters["lighting_ms"] = median(lighting);
}

/// Frames in which all points of the mesh move, on plain VTK and with shadows, in turns.
void deforming(benchmark::State& state, const std::string& model)
{
  const vtkSmartPointer<vtkAlgorithm> source = makeSource(model);
  source->Update();
  auto* rest = vtkPolyData::SafeDownCast(source->GetOutputDataObject(0));
  vtkNew<vtkPolyData> mesh;
  mesh->DeepCopy(rest);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(mesh);
  MovingLightScene moving(producer);
  vtkShadowVolumePass* pass = moving.scene.pass;
  const double waves = 30.0 / mesh->GetLength();
  const auto move = [&](double phase)
  {
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      double point[3];
      rest->GetPoint(i, point);
      const double scale = 1.0 + 0.02 * std::sin(waves * point[0] + phase);
      mesh->GetPoints()->SetPoint(i, point[0], scale * point[1], scale * point[2]);
    }
    mesh->GetPoints()->Modified();
  };
  std::vector<double> plain;
  std::vector<double> shadowed;
  std::vector<double> scene;
  double phase = 0.0;
  for (auto _ : state)
  {
    for (vtkRenderPass* each : {static_cast<vtkRenderPass*>(nullptr), static_cast<vtkRenderPass*>(pass)})
    {
      // A pass that was just attached has VTK build its shaders again; its second frame counts.
      moving.draw(each);
      move(phase += 0.3);
      (each == nullptr ? plain : shadowed).push_back(moving.draw(each));
    }
    scene.push_back(pass->GetSceneMilliseconds());
    state.SetIterationTime(1e-3 * shadowed.back());
  }
  state.counters["plain_ms"] = median(plain);
  state.counters["volumes_ms"] = median(shadowed);
  state.counters["scene_ms"] = median(scene);
}

/// Kilobytes from /proc; 0 where there is no such file.
double readStatus(const std::string& key)
{
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word)
  {
    if (word == key + ":")
    {
      double kilobytes = 0.0;
      status >> kilobytes;
      return kilobytes;
    }
  }
  return 0.0;
}

/// Highest memory of the first shadowed frame above that of plain VTK's frames, a triangle. Software GL: its
/// buffers count.
void peakMemory(benchmark::State& state, int triangles, int stencilMethod)
{
  for (auto _ : state)
  {
    MovingLightScene moving(makeSource("sphere-" + std::to_string(triangles)));
    moving.scene.pass->SetStencilMethod(stencilMethod);
    moving.draw(nullptr);
    moving.draw(nullptr);
    const double before = readStatus("VmRSS");
    std::ofstream("/proc/self/clear_refs") << 5; // resets the high-water mark
    state.SetIterationTime(1e-3 * moving.draw(moving.scene.pass));
    const double count = static_cast<double>(moving.scene.pass->GetAmbientTriangles());
    state.counters["peak_bytes_per_triangle"] = 1024.0 * (readStatus("VmHWM") - before) / count;
    state.counters["kept_bytes_per_triangle"] =
        static_cast<double>(moving.scene.pass->GetMemorySize()) / count;
  }
}

/// The first shadowed frame in a window, and what of it goes into trying out the method there.
void firstFrame(benchmark::State& state, int silhouetteMethod)
{
  std::vector<double> first;
  std::vector<double> check;
  for (auto _ : state)
  {
    MovingLightScene moving(makeSource("sphere-6000"));
    moving.scene.pass->SetSilhouetteMethod(silhouetteMethod);
    moving.scene.pass->MeasureStagesOn();
    moving.draw(nullptr);
    moving.draw(nullptr);
    first.push_back(moving.draw(moving.scene.pass));
    check.push_back(moving.scene.pass->GetCheckMilliseconds());
    state.SetIterationTime(1e-3 * first.back());
  }
  state.counters["first_ms"] = median(first);
  state.counters["check_ms"] = median(check);
}

std::vector<std::string> findModels(int argc, char** argv)
{
  std::vector<std::string> models(argv + 1, argv + argc);
  if (models.empty())
  {
    models = {"sphere-6000", "sphere-70000"};
    for (const char* name : {"spot", "teapot", "stanford-bunny"})
    {
      const std::string path = std::string(MODEL_FOLDER) + "/" + name + ".obj";
      if (std::filesystem::exists(path))
      {
        models.push_back(path);
      }
    }
  }
  return models;
}

} // namespace

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  const std::vector<std::string> models = findModels(argc, argv);
  for (const std::string& model : models)
  {
    const std::string name = std::filesystem::path(model).stem().string();
    for (const bool cameraMoves : {false, true})
    {
      const std::string camera = cameraMoves ? "/auto/camera-moves" : "/auto";
      benchmark::RegisterBenchmark(("FrameAgainstShadowMap/" + name + camera).c_str(), frameAgainstShadowMap,
                                   model, cameraMoves)
          ->UseManualTime()
          ->Iterations(40)
          ->Unit(benchmark::kMillisecond);
    }
    benchmark::RegisterBenchmark(("Deforming/" + name).c_str(), deforming, model)
        ->UseManualTime()
        ->Iterations(20)
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(("Stages/" + name + "/zpass").c_str(), stages, model,
                                 vtkShadowVolumePass::STENCIL_ZPASS)
        ->UseManualTime()
        ->Iterations(40)
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(("Stages/" + name + "/zfail").c_str(), stages, model,
                                 vtkShadowVolumePass::STENCIL_ZFAIL)
        ->UseManualTime()
        ->Iterations(40)
        ->Unit(benchmark::kMillisecond);
  }
  for (int method = 0; method <= vtkShadowVolumePass::SILHOUETTE_COMPUTE; ++method)
  {
    const std::string name = shadow::toString(static_cast<shadow::SilhouetteMethod>(method));
    benchmark::RegisterBenchmark(("FirstFrame/" + name).c_str(), firstFrame, method)
        ->UseManualTime()
        ->Iterations(21)
        ->Unit(benchmark::kMillisecond);
  }
  shadow::benchmarks::registerFirstFrames();
  for (const int method : {vtkShadowVolumePass::STENCIL_ZPASS, vtkShadowVolumePass::STENCIL_ZFAIL})
  {
    const std::string name = method == vtkShadowVolumePass::STENCIL_ZPASS ? "zpass" : "zfail";
    benchmark::RegisterBenchmark(("PeakMemory/sphere-500000/" + name).c_str(), peakMemory, 500000, method)
        ->UseManualTime()
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
