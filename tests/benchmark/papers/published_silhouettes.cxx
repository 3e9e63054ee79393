// TA, VnV and HSD of Kolivand & Sunar 2011, and the edge buffer: operations counted beside the paper's
// formulas, then milliseconds a light and frames a second on the paper's four objects, and what HSD's
// tolerance does to the picture.
//
//   bench_published_silhouettes [--benchmark_...]

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTrivialProducer.h>

#include "CoplanarTolerance.h"
#include "FlatRegions.h"
#include "MeshFiles.h"
#include "MovingLightScene.h"
#include "OperationTables.h"
#include "PaperFormulas.h"
#include "PaperObjects.h"
#include "PublishedForms.h"
#include "SilhouetteFinder.h"
#include "TestMeshes.h"
#include "Timing.h"

namespace
{

using namespace shadow;
using namespace shadow::benchmarks;

/// An object, prepared once for all its benchmarks.
struct PreparedObject
{
  explicit PreparedObject(const PaperObject& object)
      : name(object.name), paperEdges(object.paperEdges), soup(object.soup),
        geometry(test::build(object.soup)), triangles(makeTriangleMesh(geometry)),
        polygons(makeMergedMesh(geometry, findFlatRegions(geometry)))
  {
  }

  std::string name;
  std::size_t paperEdges;
  TriangleSoup soup;
  SEDGeometry geometry;
  PolygonMesh triangles;
  PolygonMesh polygons; ///< flat regions
};

/// A point light that goes round an object.
class CirclingLight
{
public:
  explicit CirclingLight(const SEDGeometry& geometry)
      : centre(0.5 * (geometry.getLowerBound() + geometry.getUpperBound())),
        size(glm::distance(geometry.getLowerBound(), geometry.getUpperBound()))
  {
  }

  glm::dvec4 next()
  {
    this->angle += 0.1;
    return {this->centre + this->size * glm::dvec3(std::cos(this->angle), 0.8, std::sin(this->angle)), 1.0};
  }

private:
  glm::dvec3 centre;
  double size;
  double angle = 0.0;
};

using Form = std::vector<DirectedEdge> (*)(const PolygonMesh&, const glm::dvec4&, Operations&);

void publishedForm(benchmark::State& state, const PreparedObject& object, Form form, bool merged)
{
  CirclingLight light(object.geometry);
  const PolygonMesh& mesh = merged ? object.polygons : object.triangles;
  std::size_t edges = 0;
  for (auto _ : state)
  {
    Operations operations;
    edges = form(mesh, light.next(), operations).size();
    benchmark::DoNotOptimize(operations);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.edges.size()));
  state.counters["silhouetteEdges"] = static_cast<double>(edges);
}

/// Facing and silhouette for a new light.
///
/// @param likeThePaper  light-facing triangles only, whatever the mesh; else as the pass has them cast
void indexedForm(benchmark::State& state, const SEDGeometry& geometry, SilhouetteMethod method,
                 bool likeThePaper)
{
  CirclingLight light(geometry);
  const auto finder = makeSilhouetteFinder(method);
  LightFacing facing;
  std::size_t edges = 0;
  for (auto _ : state)
  {
    const glm::dvec4 lightMC = light.next();
    finder->face(geometry, lightMC, facing);
    const Casting casting = likeThePaper ? Casting::LightFacing : chooseCasting(geometry, lightMC);
    edges = finder->find(geometry, facing, casting).size();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(geometry.getEdges().size()));
  state.counters["silhouetteEdges"] = static_cast<double>(edges);
}

/// Frames in which the methods take turns, everything rebuilt for a light that moves.
void frames(benchmark::State& state, vtkAlgorithm* source, bool isBunny)
{
  MovingLightScene moving(source);
  vtkShadowVolumePass* pass = moving.scene.pass;
  const int methods = pass->GetSilhouetteMethodMaxValue() + 1;
  std::vector<std::vector<double>> milliseconds(static_cast<std::size_t>(methods));
  for (int method = 0; method < methods; ++method)
  {
    // What a method prepares from a mesh it prepares once.
    pass->SetSilhouetteMethod(method);
    moving.draw(pass);
  }
  for (auto _ : state)
  {
    double sum = 0.0;
    for (int method = 0; method < methods; ++method)
    {
      pass->SetSilhouetteMethod(method);
      milliseconds[static_cast<std::size_t>(method)].push_back(moving.draw(pass));
      sum += milliseconds[static_cast<std::size_t>(method)].back();
    }
    state.SetIterationTime(1e-3 * sum);
  }
  for (int method = 0; method < methods; ++method)
  {
    state.counters[toString(static_cast<SilhouetteMethod>(method)) + "_fps"] =
        1000.0 / median(milliseconds[static_cast<std::size_t>(method)]);
  }
  if (isBunny)
  {
    state.counters["paper_hybrid_fps"] = paperHybridFrames;
    state.counters["paper_others_fps_1"] = paperConventionalFramesIntroduction;
    state.counters["paper_others_fps_2"] = paperConventionalFramesResults;
  }
}

vtkSmartPointer<vtkAlgorithm> makeSource(const TriangleSoup& soup)
{
  vtkNew<vtkPoints> points;
  for (const glm::dvec3& point : soup.points)
  {
    points->InsertNextPoint(point.x, point.y, point.z);
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& triangle : soup.triangles)
  {
    triangles->InsertNextCell({triangle[0], triangle[1], triangle[2]});
  }
  vtkNew<vtkPolyData> polyData;
  polyData->SetPoints(points);
  polyData->SetPolys(triangles);
  auto producer = vtkSmartPointer<vtkTrivialProducer>::New();
  producer->SetOutput(polyData);
  return producer;
}

void registerIndexed(const std::string& name, const std::shared_ptr<const SEDGeometry>& geometry,
                     bool likeThePaper)
{
  for (const SilhouetteMethod method :
       {SilhouetteMethod::Triangular, SilhouetteMethod::VisibleNonVisible, SilhouetteMethod::Hybrid,
        SilhouetteMethod::EdgeBuffer, SilhouetteMethod::BruteForce, SilhouetteMethod::Hierarchical,
        SilhouetteMethod::TopologyAwareMesh})
  {
    benchmark::RegisterBenchmark(("Silhouette/" + name + "/" + toString(method) + "/indexed").c_str(),
                                 [geometry, method, likeThePaper](auto& state)
                                 { indexedForm(state, *geometry, method, likeThePaper); })
        ->Unit(benchmark::kMicrosecond);
  }
}

void registerObject(const std::shared_ptr<const PreparedObject>& object)
{
  const std::string prefix = "Silhouette/" + object->name + "/";
  const auto addPublished = [&](const std::string& name, Form form, bool merged)
  {
    benchmark::RegisterBenchmark((prefix + name + "/published").c_str(), [object, form, merged](auto& state)
                                 { publishedForm(state, *object, form, merged); })
        ->Unit(benchmark::kMicrosecond);
  };
  addPublished("triangular", findByTriangular, false);
  addPublished("visible-nonvisible", findByVisibleNonVisible, false);
  addPublished("hybrid", findByTriangular, true);
  registerIndexed(object->name, std::shared_ptr<const SEDGeometry>(object, &object->geometry), true);
}

void registerFrames(const std::string& name, const vtkSmartPointer<vtkAlgorithm>& source, bool isBunny)
{
  benchmark::RegisterBenchmark(("Frame/" + name).c_str(),
                               [source, isBunny](auto& state) { frames(state, source, isBunny); })
      ->UseManualTime()
      ->Iterations(100)
      ->Unit(benchmark::kMillisecond);
}

/// The paper's objects beside ours.
void registerObjects(const std::string& bunny)
{
  std::printf("\nThe paper's objects (table 1), and what stands for them here\n");
  for (const PaperObject& made : makePaperObjects(bunny))
  {
    const auto object = std::make_shared<const PreparedObject>(made);
    std::printf(
        "  %-8s paper: %5zu edges; here: %5zu edges between %zu flat faces, %zu edges of %zu triangles\n",
        object->name.c_str(), object->paperEdges, object->polygons.edges.size(),
        object->polygons.faces.size(), object->triangles.edges.size(), object->triangles.faces.size());
    registerObject(object);
    registerFrames(object->name, makeSource(object->soup), object->name == "bunny");
  }
  if (!std::filesystem::exists(bunny))
  {
    std::printf("  bunny    left out: there is no %s\n", std::filesystem::path(bunny).filename().c_str());
    return;
  }
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(bunny.c_str());
  registerFrames("whole-bunny", vtkSmartPointer<vtkAlgorithm>(reader), false);
}

/// Meshes of today's size, on which the published forms would take seconds.
void registerMeshes(const std::string& modelFolder)
{
  for (const char* name : {"fandisk", "stanford-bunny"})
  {
    const std::string file = modelFolder + "/" + name + ".obj";
    if (std::filesystem::exists(file))
    {
      const auto geometry = std::make_shared<const SEDGeometry>(test::build(test::readMeshFile(file)));
      registerIndexed(name, geometry, false);
    }
  }
  const auto torus = std::make_shared<const SEDGeometry>(test::build(test::makeTorus(1.0, 0.4, 1000, 500)));
  registerIndexed("torus-1000000", torus, false);
}

} // namespace

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  if (!printOperationTables())
  {
    return 1;
  }
  const std::string models = MODEL_FOLDER;
  registerObjects(models + "/stanford-bunny.obj");
  registerMeshes(models);
  registerCoplanarTolerance(models);
  std::printf(
      "\nFrames a second by each method, in turns; the paper's, with a bunny on other hardware, beside "
      "them\n\n");
  std::fflush(stdout);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
