// What HSD prepares: flat regions of a mesh without any, and of one that is a single plane. Items are
// triangles.

#include <algorithm>
#include <cstdint>

#include <benchmark/benchmark.h>

#include "AllocationCounter.h"
#include "FlatRegions.h"
#include "TestMeshes.h"

namespace
{

using shadow::test::AllocationCounter;

/// side * side squares in a tilted plane, two triangles each.
shadow::TriangleSoup makePlane(std::int64_t side)
{
  const auto cells = static_cast<std::uint32_t>(side);
  shadow::TriangleSoup soup;
  for (std::uint32_t y = 0; y <= cells; ++y)
  {
    for (std::uint32_t x = 0; x <= cells; ++x)
    {
      soup.points.emplace_back(x, y, 2.0 * x - 3.0 * y);
    }
  }
  for (std::uint32_t y = 0; y < cells; ++y)
  {
    for (std::uint32_t x = 0; x < cells; ++x)
    {
      const std::uint32_t a = y * (cells + 1) + x;
      soup.triangles.push_back({a, a + 1, a + cells + 2});
      soup.triangles.push_back({a, a + cells + 2, a + cells + 1});
    }
  }
  return soup;
}

shadow::TriangleSoup makeTorus(std::int64_t across)
{
  const auto count = static_cast<std::uint32_t>(across);
  return shadow::test::makeTorus(1.0, 0.4, 2 * count, count);
}

void findFlatRegions(benchmark::State& state, shadow::TriangleSoup (*make)(std::int64_t))
{
  const shadow::SEDGeometry geometry = shadow::test::build(make(state.range(0)));
  const auto triangles = static_cast<double>(geometry.getTriangles().size());
  std::size_t peak = 0;
  for (auto _ : state)
  {
    const std::size_t before = AllocationCounter::getCurrent();
    AllocationCounter::resetPeak();
    const shadow::FlatRegions regions = shadow::findFlatRegions(geometry);
    peak = std::max(peak, AllocationCounter::getPeak() - before);
    state.counters["regions"] = static_cast<double>(regions.getRegionCount());
    state.counters["keptBytesPerTriangle"] = static_cast<double>(regions.getMemorySize()) / triangles;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(triangles) * state.iterations());
  state.counters["peakBytesPerTriangle"] = static_cast<double>(peak) / triangles;
}

} // namespace

BENCHMARK_CAPTURE(findFlatRegions, torus, makeTorus)
    ->Name("FlatRegions/torus")
    ->Arg(132)
    ->Arg(500)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(findFlatRegions, plane, makePlane)
    ->Name("FlatRegions/plane")
    ->Arg(187)
    ->Arg(707)
    ->Unit(benchmark::kMillisecond);
