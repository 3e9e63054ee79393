// What finding all silhouettes on the GPU costs: the vertex texture (Brabec & Seidel 2003) with the facing of
// each triangle evaluated once, evaluated for every edge anew, and as published, and compute shaders beside
// it. Counters: silhouettes of lights in the plane of many triangles that are left open, and the vertices
// where.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "Capabilities.h"
#include "Light.h"
#include "OpenGL.h"
#include "SilhouetteProbe.h"
#include "TestMeshes.h"

using namespace shadow;
using namespace shadow::test;

namespace
{

constexpr std::uint32_t torusSide = 200; // 80,000 triangles
constexpr std::uint32_t inPlaneLights = 400;

SilhouetteProbe& getProbe()
{
  static SilhouetteProbe probe(build(makeTorus(2.0, 0.5, torusSide, torusSide)));
  return probe;
}

/// Point lights around the torus, elsewhere in each frame.
std::vector<glm::dvec4> makeLights(std::int64_t count, int frame)
{
  std::vector<glm::dvec4> lights;
  for (std::int64_t i = 0; i < count; ++i)
  {
    const double angle = 0.4 * static_cast<double>(i) + 0.01 * frame;
    lights.emplace_back(4.0 * std::cos(angle), 4.0 * std::sin(angle), 3.0, 1.0);
  }
  return lights;
}

/// How many of the in-plane lights' silhouettes are open, and at how many vertices.
template <class Method>
void countOpen(benchmark::State& state, Method& method)
{
  SilhouetteProbe& probe = getProbe();
  std::size_t silhouettes = 0;
  std::size_t vertices = 0;
  for (std::uint32_t first = 0; first < inPlaneLights; first += maximumLights)
  {
    std::vector<glm::dvec4> lights;
    for (std::uint32_t place = first; place < std::min(first + maximumLights, inPlaneLights); ++place)
    {
      lights.push_back(makeInPlaneLight(probe.getGeometry(), torusSide, place));
    }
    probe.find(method, lights);
    for (const std::vector<SilhouetteEdge>& silhouette : probe.read(method))
    {
      const std::size_t open = countOpenVertices(probe.getGeometry(), silhouette);
      silhouettes += open > 0 ? 1 : 0;
      vertices += open;
    }
  }
  state.counters["open_of_400"] = static_cast<double>(silhouettes);
  state.counters["open_vertices"] = static_cast<double>(vertices);
}

template <class Method>
void find(benchmark::State& state, Method& method)
{
  SilhouetteProbe& probe = getProbe();
  probe.find(method, makeLights(state.range(0), 0));
  glFinish();
  int frame = 0;
  for (auto step : state)
  {
    static_cast<void>(step);
    probe.find(method, makeLights(state.range(0), ++frame));
    glFinish();
  }
  state.SetItemsProcessed(state.iterations() * state.range(0) *
                          static_cast<std::int64_t>(probe.getGeometry().getEdges().size()));
  if (state.range(0) == maximumLights)
  {
    countOpen(state, method);
  }
  method.release(false);
}

void vertexTexture(benchmark::State& state, VertexTexture::Normals normals)
{
  VertexTexture method(normals);
  find(state, method);
}

void compute(benchmark::State& state)
{
  if (!getProbe().canCompute())
  {
    state.SkipWithError("needs OpenGL 4.3");
    return;
  }
  ComputeSilhouette method;
  find(state, method);
}

/// Few, some, as many lights as there may be.
void setUp(benchmark::internal::Benchmark* benchmark)
{
  benchmark->Arg(1)
      ->Arg(8)
      ->Arg(maximumLights)
      ->ArgName("lights")
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

} // namespace

BENCHMARK_CAPTURE(vertexTexture, oncePerTriangle, VertexTexture::Normals::OncePerTriangle)->Apply(setUp);
BENCHMARK_CAPTURE(vertexTexture, perEdge, VertexTexture::Normals::PerEdge)->Apply(setUp);
BENCHMARK_CAPTURE(vertexTexture, asPublished, VertexTexture::Normals::PerEdgeAsPublished)->Apply(setUp);
BENCHMARK(compute)->Apply(setUp);

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  getProbe();
  benchmark::AddCustomContext(
      "OpenGL renderer", std::string(reinterpret_cast<const char*>(glGetString(GL_RENDERER))) +
                             (queryCapabilities().software ? " (software: these are a CPU's times)" : ""));
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
