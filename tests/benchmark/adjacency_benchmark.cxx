// What a mesh costs before anything is drawn: adjacency once, then facing and silhouette for each light.
// Items are triangles.

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>

#include "AllocationCounter.h"
#include "BruteForceSilhouette.h"
#include "OverlapBound.h"
#include "ShadowVolume.h"
#include "TestMeshes.h"

namespace
{

using shadow::test::AllocationCounter;

const glm::dvec4 lightMC(3.0, 4.0, 5.0, 1.0);

/// How the triangles arrive.
enum class Input
{
  Shared,   ///< neighbours use the same points
  Unshared, ///< three points a triangle, as in an STL file
  Scrambled ///< half of the triangles wound the wrong way
};

/// A torus of 2 * across * 2 * across triangles.
shadow::TriangleSoup makeInput(std::int64_t across, Input input)
{
  const auto count = static_cast<std::uint32_t>(across);
  shadow::TriangleSoup soup = shadow::test::makeTorus(1.0, 0.4, 2 * count, count);
  if (input == Input::Scrambled)
  {
    shadow::test::turnRandomly(soup, 1);
  }
  soup.points.shrink_to_fit();
  soup.triangles.shrink_to_fit();
  return input == Input::Unshared ? shadow::test::makeUnshared(soup) : soup;
}

void countItems(benchmark::State& state, std::size_t triangles)
{
  state.SetItemsProcessed(static_cast<std::int64_t>(triangles) * state.iterations());
  state.counters["triangles"] = static_cast<double>(triangles);
}

void buildAdjacency(benchmark::State& state, Input input)
{
  const shadow::TriangleSoup soup = makeInput(state.range(0), input);
  std::size_t peak = 0;
  for (auto _ : state)
  {
    state.PauseTiming();
    const std::size_t before = AllocationCounter::getCurrent();
    shadow::TriangleSoup copy = soup;
    AllocationCounter::resetPeak();
    std::string error;
    state.ResumeTiming();
    auto geometry = shadow::buildSEDGeometry(std::move(copy), shadow::SEDGeometryOptions(), error);
    benchmark::DoNotOptimize(geometry);
    state.PauseTiming();
    peak = AllocationCounter::getPeak() - before;
    geometry.reset();
    state.ResumeTiming();
  }
  countItems(state, soup.triangles.size());
  state.counters["peakBytesPerTriangle"] =
      static_cast<double>(peak) / static_cast<double>(soup.triangles.size());
}

/// What is taken over from the mesh before it moved.
enum class Kept
{
  Order,
  OrderAndEdges
};

void rebuildMoved(benchmark::State& state, Kept kept)
{
  shadow::TriangleSoup soup = makeInput(state.range(0), Input::Shared);
  shadow::SEDGeometry previous = shadow::test::build(soup);
  shadow::SEDGeometryOptions options;
  options.previous = &previous;
  if (kept == Kept::Order)
  {
    // Of a mesh that runs the other way nothing but the order fits.
    shadow::test::turnInsideOut(soup);
    previous = shadow::test::build(soup, options);
    shadow::test::turnInsideOut(soup);
  }
  for (glm::dvec3& point : soup.points)
  {
    point.x += 0.1 * std::sin(5.0 * point.y);
  }
  for (auto _ : state)
  {
    state.PauseTiming();
    shadow::TriangleSoup copy = soup;
    std::string error;
    state.ResumeTiming();
    auto geometry = shadow::buildSEDGeometry(std::move(copy), options, error);
    benchmark::DoNotOptimize(geometry);
    state.PauseTiming();
    geometry.reset();
    state.ResumeTiming();
  }
  countItems(state, soup.triangles.size());
}

void computeFacing(benchmark::State& state)
{
  const shadow::SEDGeometry geometry = shadow::test::build(makeInput(state.range(0), Input::Shared));
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(shadow::computeFacing(geometry, lightMC));
  }
  countItems(state, geometry.getTriangles().size());
}

void findSilhouette(benchmark::State& state, shadow::Casting casting)
{
  const shadow::SEDGeometry geometry = shadow::test::build(makeInput(state.range(0), Input::Shared));
  const shadow::LightFacing facing = shadow::computeFacing(geometry, lightMC);
  const shadow::BruteForceSilhouette finder;
  std::size_t edges = 0;
  for (auto _ : state)
  {
    const auto silhouette = finder.find(geometry, facing, casting);
    edges = silhouette.size();
    benchmark::DoNotOptimize(silhouette.data());
  }
  countItems(state, geometry.getTriangles().size());
  state.counters["silhouetteEdges"] = static_cast<double>(edges);
}

void extrude(benchmark::State& state, bool withCaps)
{
  const shadow::SEDGeometry geometry = shadow::test::build(makeInput(state.range(0), Input::Shared));
  const shadow::LightFacing facing = shadow::computeFacing(geometry, lightMC);
  const auto silhouette = shadow::BruteForceSilhouette().find(geometry, facing, shadow::Casting::LightFacing);
  const shadow::ShadowVolumeOptions options{withCaps,
                                            withCaps ? shadow::DarkCap::Triangles : shadow::DarkCap::None};
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(shadow::extrudeSilhouette(geometry, silhouette, facing,
                                                       shadow::Casting::LightFacing, lightMC, options));
  }
  countItems(state, geometry.getTriangles().size());
}

void boundOverlap(benchmark::State& state)
{
  const shadow::SEDGeometry geometry = shadow::test::build(makeInput(state.range(0), Input::Shared));
  const shadow::LightFacing facing = shadow::computeFacing(geometry, lightMC);
  const auto silhouette = shadow::BruteForceSilhouette().find(geometry, facing, shadow::Casting::LightFacing);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(
        shadow::boundOverlap(geometry, silhouette, facing, shadow::Casting::LightFacing, lightMC));
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(silhouette.size()) * state.iterations());
}

/// 69,696 and 1,000,000 triangles.
void sizes(benchmark::internal::Benchmark* benchmark)
{
  benchmark->Arg(132)->Arg(500)->Unit(benchmark::kMillisecond);
}

} // namespace

BENCHMARK_CAPTURE(buildAdjacency, shared, Input::Shared)->Name("Adjacency/torus/shared")->Apply(sizes);
BENCHMARK_CAPTURE(buildAdjacency, unshared, Input::Unshared)->Name("Adjacency/torus/unshared")->Apply(sizes);
BENCHMARK_CAPTURE(buildAdjacency, scrambled, Input::Scrambled)
    ->Name("Adjacency/torus/scrambled")
    ->Apply(sizes);
BENCHMARK_CAPTURE(rebuildMoved, order, Kept::Order)->Name("Adjacency/torus/moved/order")->Apply(sizes);
BENCHMARK_CAPTURE(rebuildMoved, edges, Kept::OrderAndEdges)
    ->Name("Adjacency/torus/moved/orderAndEdges")
    ->Apply(sizes);
BENCHMARK(computeFacing)->Name("Facing/torus")->Apply(sizes);
BENCHMARK_CAPTURE(findSilhouette, closed, shadow::Casting::LightFacing)
    ->Name("Silhouette/torus/bruteforce/lightFacing")
    ->Apply(sizes);
BENCHMARK_CAPTURE(findSilhouette, soup, shadow::Casting::EveryTriangle)
    ->Name("Silhouette/torus/bruteforce/everyTriangle")
    ->Apply(sizes);
BENCHMARK_CAPTURE(extrude, sides, false)->Name("ShadowVolume/torus/sides")->Apply(sizes);
BENCHMARK_CAPTURE(extrude, caps, true)->Name("ShadowVolume/torus/caps")->Apply(sizes);
BENCHMARK(boundOverlap)->Name("OverlapBound/torus")->Apply(sizes);
