// What a new light costs on a prepared mesh: the facing bits of all triangles, written anew, and the list of
// silhouette edges. For every method; beside vtkPolyDataSilhouette, beside copying memory, and as meshes
// grow. What is compared takes turns, and a light moves from run to run. Medians of one run.

#include <cmath>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataSilhouette.h>

#include "MeshFiles.h"
#include "SilhouetteFinder.h"
#include "SmpParallelFor.h"
#include "TestMeshes.h"
#include "Timing.h"

namespace
{

using shadow::SEDGeometry;
using shadow::SilhouetteMethod;
using shadow::TriangleSoup;
using shadow::benchmarks::measure;
using shadow::benchmarks::median;

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

using MakeMesh = TriangleSoup (*)(std::int64_t across);

/// Around the mesh, from run to run elsewhere: close above it, or a direction.
class MovingLight
{
public:
  MovingLight(const SEDGeometry& geometry, bool isDirectional)
      : centre(0.5 * (geometry.getLowerBound() + geometry.getUpperBound())),
        half(0.5 * (geometry.getUpperBound() - geometry.getLowerBound())), directional(isDirectional)
  {
  }

  glm::dvec4 move()
  {
    this->angle += 0.1;
    const glm::dvec3 around(std::cos(this->angle), std::sin(this->angle), 1.25);
    return this->directional
               ? glm::dvec4(around, 0.0)
               : glm::dvec4(this->centre + glm::dvec3(0.4, 0.4, 1.0) * around * this->half, 1.0);
  }

private:
  glm::dvec3 centre;
  glm::dvec3 half;
  bool directional;
  double angle = 0.0;
};

/// One method on one mesh, in memory that it has used before.
class Run
{
public:
  Run(const SEDGeometry& theGeometry, SilhouetteMethod method, shadow::ParallelFor parallelFor = {})
      : geometry(theGeometry), finder(makeSilhouetteFinder(method, 0.0, std::move(parallelFor)))
  {
  }

  double measureOnce(const glm::dvec4& lightMC)
  {
    this->milliseconds.push_back(measure([&] { this->find(lightMC); }));
    return this->milliseconds.back();
  }

  void find(const glm::dvec4& lightMC)
  {
    this->finder->face(this->geometry, lightMC, this->facing);
    const auto edges =
        this->finder->find(this->geometry, this->facing, chooseCasting(this->geometry, lightMC));
    this->edgeCount = edges.size();
    benchmark::DoNotOptimize(edges.data());
  }

  double getMedian() const { return median(this->milliseconds); }
  std::size_t countEdges() const { return this->edgeCount; }

private:
  const SEDGeometry& geometry;
  std::unique_ptr<shadow::SilhouetteFinder> finder;
  shadow::LightFacing facing;
  std::vector<double> milliseconds;
  std::size_t edgeCount = 0;
};

/// Bytes that brute force must read and write for one light.
std::size_t countBytes(const SEDGeometry& geometry)
{
  const shadow::EdgeTable& edges = geometry.getEdgeTable();
  const std::size_t words = geometry.getPlaneBlocks().size();
  // Planes; two words of bits written and one read; the table of edges.
  return words * sizeof(shadow::PlaneBlock) + 24 * words + 2 * edges.countInner() + 5 * edges.countOuter() +
         4 * edges.borders.size() + 8 * words;
}

/// Copies as much memory as brings the bytes read and written to a given number.
class MemoryCopy
{
public:
  explicit MemoryCopy(std::size_t bytes) : from(bytes / 2, 1), to(bytes / 2, 2) {}

  void measureOnce()
  {
    this->milliseconds.push_back(
        measure([&] { std::memcpy(this->to.data(), this->from.data(), this->from.size()); }));
    benchmark::DoNotOptimize(this->to.data());
  }

  double getMedian() const { return median(this->milliseconds); }
  double getBytesPerSecond() const
  {
    return 2e3 * static_cast<double>(this->from.size()) / this->getMedian();
  }

private:
  std::vector<char> from;
  std::vector<char> to;
  std::vector<double> milliseconds;
};

/// vtkPolyDataSilhouette, prepared: it has seen its input.
class VtkSilhouette
{
public:
  explicit VtkSilhouette(const TriangleSoup& soup)
  {
    vtkNew<vtkPoints> points;
    for (const glm::dvec3& point : soup.points)
    {
      points->InsertNextPoint(&point.x);
    }
    vtkNew<vtkCellArray> triangles;
    for (const auto& corners : soup.triangles)
    {
      triangles->InsertNextCell({corners[0], corners[1], corners[2]});
    }
    vtkNew<vtkPolyData> mesh;
    mesh->SetPoints(points);
    mesh->SetPolys(triangles);
    this->filter->SetInputData(mesh);
    this->filter->SetDirectionToSpecifiedOrigin();
    this->filter->SetEnableFeatureAngle(0);
    this->filter->Update();
  }

  void measureOnce(const glm::dvec3& lightWC)
  {
    this->filter->SetOrigin(lightWC.x, lightWC.y, lightWC.z);
    this->milliseconds.push_back(measure([&] { this->filter->Update(); }));
  }

  double getMedian() const { return median(this->milliseconds); }

private:
  vtkNew<vtkPolyDataSilhouette> filter;
  std::vector<double> milliseconds;
};

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
void againstVtk(benchmark::State& state, const TriangleSoup& soup)
{
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
    double sum = 0.0;
    for (std::size_t size = 0; size < sizes.size(); ++size)
    {
      bruteForce[size].measureOnce(lights[size].move());
      sum = 0.0;
      for (int turn = 0; turn < 10; ++turn)
      {
        sum += hierarchical[size].measureOnce(lights[size].move());
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

/// The bunny where it is found, else a torus of the same size.
TriangleSoup makeBunny()
{
  const std::string file = std::string(MODEL_FOLDER) + "/stanford-bunny.obj";
  if (!std::filesystem::exists(file))
  {
    return makeTorus(132);
  }
  return shadow::test::readMeshFile(file);
}

void againstVtkOnBunny(benchmark::State& state)
{
  againstVtk(state, makeBunny());
}

void againstVtkOnMillion(benchmark::State& state)
{
  againstVtk(state, makeTorus(500));
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
  add("bunny/againstVtk", againstVtkOnBunny)->UseManualTime()->Iterations(21);
  add("torus-1000000/againstVtk", againstVtkOnMillion)->UseManualTime()->Iterations(11);
  const std::vector<std::pair<std::string, MakeMesh>> meshes = {{"torus", makeTorus},
                                                                {"dented", makeDentedTorus}};
  for (const auto& [name, makeMesh] : meshes)
  {
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
