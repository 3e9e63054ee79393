// What a new light costs on a prepared mesh: the facing bits of all triangles, written anew, and the list of
// silhouette edges. For every method; beside vtkPolyDataSilhouette, beside copying memory, and as meshes
// grow. What is compared takes turns, and a light moves from run to run. Medians of one run.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "MeshFiles.h"
#include "SilhouetteRuns.h"
#include "SmpParallelFor.h"
#include "TestMeshes.h"
#include "VtkSilhouette.h"

namespace
{

using shadow::SEDGeometry;
using shadow::SilhouetteMethod;
using shadow::TriangleSoup;
using shadow::benchmarks::measure;
using shadow::benchmarks::median;
using shadow::benchmarks::MemoryCopy;
using shadow::benchmarks::MovingLight;
using shadow::benchmarks::Run;
using shadow::benchmarks::VtkSilhouette;

/// 4 * across^2 triangles.
TriangleSoup makeTorus(std::int64_t across)
{
  const auto count = static_cast<std::uint32_t>(across);
  return shadow::test::makeTorus(1.0, 0.4, 2 * count, count);
}

/// The same with dents all over, which the silhouette runs around.
TriangleSoup makeDentedTorus(std::int64_t across)
{
  TriangleSoup soup = makeTorus(across);
  for (glm::dvec3& point : soup.points)
  {
    point *= 1.0 + 0.02 * std::sin(23.0 * point.x) * std::sin(19.0 * point.y) * std::sin(29.0 * point.z);
  }
  return soup;
}

/// The bunny where it is found, else a torus of the same size.
TriangleSoup makeBunny(std::int64_t /*across*/)
{
  const std::string file = std::string(MODEL_FOLDER) + "/stanford-bunny.obj";
  if (!std::filesystem::exists(file))
  {
    return makeTorus(132);
  }
  return shadow::test::readMeshFile(file);
}

using MakeMesh = TriangleSoup (*)(std::int64_t across);

/// Bytes that brute force must read and write for one light.
std::size_t countBytes(const SEDGeometry& geometry)
{
  const shadow::EdgeTable& edges = geometry.getEdgeTable();
  const std::size_t words = geometry.getPlaneBlocks().size();
  // Planes; two words of bits written and one read; the table of edges.
  return words * sizeof(shadow::PlaneBlock) + 24 * words + edges.getMemorySize();
}

void setRates(benchmark::State& state, std::size_t triangles, std::size_t bytes)
{
  state.SetItemsProcessed(static_cast<std::int64_t>(triangles) * state.iterations());
  if (bytes > 0)
  {
    state.SetBytesProcessed(static_cast<std::int64_t>(bytes) * state.iterations());
  }
}

/// Brute force, alone and with VTK's threads, and Auto beside VTK and beside a memory copy; time is that of
/// brute force alone.
void againstVtk(benchmark::State& state, MakeMesh makeMesh)
{
  constexpr std::int64_t acrossMillion = 500;
  const TriangleSoup soup = makeMesh(acrossMillion);
  const SEDGeometry geometry = shadow::test::build(soup);
  const std::size_t bytes = countBytes(geometry);
  VtkSilhouette vtk(soup);
  Run bruteForce(geometry, SilhouetteMethod::BruteForce);
  Run threaded(geometry, SilhouetteMethod::BruteForce, shadow::makeSmpParallelFor());
  Run best(geometry, SilhouetteMethod::Auto);
  MemoryCopy copy(bytes);
  MemoryCopy copyFromMemory(std::size_t{1} << 29);
  MovingLight light(geometry, false);
  std::vector<double> cold;
  for (auto _ : state)
  {
    const glm::dvec4 lightMC = light.move();
    vtk.measureOnce(glm::dvec3(lightMC) + geometry.getOrigin());
    copyFromMemory.measureOnce();
    cold.push_back(measure([&] { bruteForce.find(lightMC); }));
    // What stands beside each other is measured with the same caches: as the run before left them.
    double sum = 0.0;
    for (int turn = 0; turn < 10; ++turn)
    {
      sum += bruteForce.measureOnce(light.move());
    }
    for (int turn = 0; turn < 10; ++turn)
    {
      threaded.measureOnce(light.move());
    }
    for (int turn = 0; turn < 10; ++turn)
    {
      best.measureOnce(light.move());
    }
    for (int turn = 0; turn < 10; ++turn)
    {
      copy.measureOnce();
    }
    state.SetIterationTime(1e-4 * sum);
  }
  setRates(state, geometry.getTriangles().size(), bytes);
  state.counters["triangles"] = static_cast<double>(geometry.getTriangles().size());
  state.counters["vtk_ms"] = vtk.getMedian();
  state.counters["brute_ms"] = bruteForce.getMedian();
  state.counters["brute_cold_ms"] = median(cold);
  state.counters["brute_threads_ms"] = threaded.getMedian();
  state.counters["auto_ms"] = best.getMedian();
  state.counters["vtk_over_brute"] = vtk.getMedian() / bruteForce.getMedian();
  state.counters["vtk_over_brute_threads"] = vtk.getMedian() / threaded.getMedian();
  state.counters["vtk_over_auto"] = vtk.getMedian() / best.getMedian();
  state.counters["bytes_per_triangle"] =
      static_cast<double>(bytes) / static_cast<double>(geometry.getTriangles().size());
  state.counters["copy_GBps"] = 1e-9 * copy.getBytesPerSecond();
  state.counters["memory_copy_GBps"] = 1e-9 * copyFromMemory.getBytesPerSecond();
  state.counters["brute_over_copy"] = bruteForce.getMedian() / copy.getMedian();
  state.counters["cold_over_memory_copy"] =
      1e-3 * median(cold) / (static_cast<double>(bytes) / copyFromMemory.getBytesPerSecond());
}

/// 250 thousand, 500 thousand, 1, 2 and 4 million triangles; time is that of hierarchical at the last one.
void growth(benchmark::State& state, MakeMesh makeMesh, bool directional)
{
  const std::vector<std::int64_t> sizes = {250, 354, 500, 707, 1000};
  std::vector<SEDGeometry> geometries;
  for (const std::int64_t across : sizes)
  {
    geometries.push_back(shadow::test::build(makeMesh(across)));
  }
  std::vector<Run> hierarchical;
  std::vector<Run> bruteForce;
  std::vector<MovingLight> lights;
  for (const SEDGeometry& geometry : geometries)
  {
    hierarchical.emplace_back(geometry, SilhouetteMethod::Hierarchical);
    bruteForce.emplace_back(geometry, SilhouetteMethod::BruteForce);
    lights.emplace_back(geometry, directional);
  }
  for (auto _ : state)
  {
    for (std::size_t size = 0; size < sizes.size(); ++size)
    {
      bruteForce[size].measureOnce(lights[size].move());
    }
    // Sizes take turns as well: a new light in a program finds in the fast caches what other work left there.
    double sum = 0.0;
    for (int turn = 0; turn < 10; ++turn)
    {
      for (std::size_t size = 0; size < sizes.size(); ++size)
      {
        const double milliseconds = hierarchical[size].measureOnce(lights[size].move());
        sum += size + 1 == sizes.size() ? milliseconds : 0.0;
      }
    }
    state.SetIterationTime(1e-4 * sum);
  }
  setRates(state, geometries.back().getTriangles().size(), 0);
  double most = 0.0;
  for (std::size_t size = 0; size < sizes.size(); ++size)
  {
    state.counters["ms_" + std::to_string(size)] = hierarchical[size].getMedian();
    if (size > 0)
    {
      most = std::max(most, hierarchical[size].getMedian() / hierarchical[size - 1].getMedian());
    }
  }
  state.counters["largest_growth"] = most;
  state.counters["brute_ms"] = bruteForce.back().getMedian();
  state.counters["brute_over_hierarchical"] = bruteForce.back().getMedian() / hierarchical.back().getMedian();
  state.counters["edges"] = static_cast<double>(hierarchical.back().countEdges());
}

/// One method alone.
void newLight(benchmark::State& state, MakeMesh makeMesh, SilhouetteMethod method)
{
  const SEDGeometry geometry = shadow::test::build(makeMesh(state.range(0)));
  MovingLight light(geometry, false);
  Run run(geometry, method);
  for (auto _ : state)
  {
    run.find(light.move());
  }
  setRates(state, geometry.getTriangles().size(),
           method == SilhouetteMethod::BruteForce ? countBytes(geometry) : 0);
  state.counters["triangles"] = static_cast<double>(geometry.getTriangles().size());
  state.counters["edges"] = static_cast<double>(run.countEdges());
}

} // namespace

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  const auto add = [](const std::string& name, auto function, auto... arguments)
  {
    return benchmark::RegisterBenchmark(("Silhouette/" + name).c_str(), function, arguments...)
        ->Unit(benchmark::kMillisecond);
  };
  add("bunny/againstVtk", againstVtk, makeBunny)->UseManualTime()->Iterations(21);
  const std::vector<std::pair<std::string, MakeMesh>> meshes = {{"torus", makeTorus},
                                                                {"dented", makeDentedTorus}};
  for (const auto& [name, makeMesh] : meshes)
  {
    add(name + "/againstVtk", againstVtk, makeMesh)->UseManualTime()->Iterations(11);
    add(name + "/growth/point", growth, makeMesh, false)->UseManualTime()->Iterations(31);
    add(name + "/growth/direction", growth, makeMesh, true)->UseManualTime()->Iterations(31);
    for (const SilhouetteMethod method : shadow::getSilhouetteMethods())
    {
      if (!isOnGPU(method))
      {
        add(name + "/" + toString(method), newLight, makeMesh, method)->RangeMultiplier(2)->Range(16, 512);
      }
    }
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
