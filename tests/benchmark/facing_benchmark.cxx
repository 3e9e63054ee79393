// What it costs to decide which lights every triangle faces: on the CPU, and with the silhouette camera,
// whose drawing, read-back and conversion are shown apart. In turns, so that their ratio means something on a
// noisy machine.
//
//   bench_facing [--benchmark_...]   medians, in milliseconds a frame; on software GL the camera's are a
//   CPU's

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "GpuScene.h"
#include "OpenGL.h"
#include "ShadowVolume.h"
#include "Timing.h"

namespace
{

using namespace shadow;
using namespace shadow::test;
using shadow::benchmarks::measure;
using shadow::benchmarks::median;

/// A torus of about this many triangles.
TriangleSoup makeMesh(std::int64_t triangles)
{
  const auto across = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles) / 4.0));
  return makeTorus(1.0, 0.4, 2 * across, across);
}

std::vector<Light> makeLights(std::int64_t count)
{
  std::mt19937 random(1);
  std::vector<Light> lights;
  for (int i = 0; i < count; ++i)
  {
    lights.push_back({i, glm::dvec4(randomPoint(random, 5.0), 1.0)});
  }
  return lights;
}

void facing(benchmark::State& state)
{
  GpuScene scene;
  scene.add(makeMesh(state.range(0)));
  const std::vector<Light> lights = makeLights(state.range(1));
  const std::string failure = scene.draw(lights);
  if (!failure.empty())
  {
    state.SkipWithError(failure.c_str());
    return;
  }
  const VETRange& range = scene.getRanges()[0];
  LightFacing found;
  std::vector<double> cpu;
  std::vector<double> draw;
  std::vector<double> readBack;
  std::vector<double> convert;
  std::string error;
  for (auto _ : state)
  {
    cpu.push_back(measure(
        [&]
        {
          for (const Light& light : lights)
          {
            found = computeFacing(*range.geometry,
                                  *lightToModel(light, range.modelToWorld, range.geometry->getOrigin()));
          }
        }));
    draw.push_back(measure(
        [&]
        {
          scene.camera.draw(scene.window, scene.triangles, lights, error);
          glFinish();
        }));
    scene.camera.startReadBack(scene.window);
    scene.camera.fetch();
    readBack.push_back(scene.camera.getReadBackTimes().getSum());
    convert.push_back(measure(
        [&]
        {
          for (const Light& light : lights)
          {
            scene.camera.getFacing(range, light, found);
          }
        }));
    state.SetIterationTime(1e-3 * (draw.back() + readBack.back() + convert.back()));
  }
  state.SetItemsProcessed(state.iterations() * state.range(1) *
                          static_cast<std::int64_t>(range.countTriangles()));
  state.counters["cpu"] = median(cpu);
  state.counters["draw"] = median(draw);
  state.counters["read_back"] = median(readBack);
  state.counters["convert"] = median(convert);
}

/// From a moved transform to positions on the GPU.
void moved(benchmark::State& state)
{
  GpuScene scene;
  const auto mover = scene.add(makeMesh(state.range(0)));
  scene.draw({});
  std::vector<double> collect;
  std::vector<double> upload;
  for (auto _ : state)
  {
    mover->matrix[3].x = mover->matrix[3].x == 0.0 ? 0.1 : 0.0;
    collect.push_back(measure([&] { scene.collector.collect(scene.root); }));
    upload.push_back(measure([&] { scene.triangles.upload(scene.collector.getCollection()); }));
    state.SetIterationTime(1e-3 * (collect.back() + upload.back()));
  }
  state.counters["collect"] = median(collect);
  state.counters["upload"] = median(upload);
}

} // namespace

BENCHMARK(facing)
    ->Name("Facing/torus")
    ->ArgNames({"triangles", "lights"})
    ->ArgsProduct({{6000, 70000, 500000}, {1, 8, 32}})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(moved)
    ->Name("Moved/torus")
    ->ArgName("triangles")
    ->Arg(6000)
    ->Arg(70000)
    ->Arg(500000)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();
