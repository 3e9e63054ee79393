#include "OutlineFaceOptions.h"

#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkNew.h>
#include <vtkSilhouettePass.h>

#include "OutlineDrawers.h"
#include "OutlineMeshes.h"
#include "RefinedMesh.h"
#include "Timing.h"

namespace shadow::benchmarks
{

namespace
{

struct Option
{
  const char* name;
  int technique;
  bool split;
  bool leaveOut;
};

constexpr std::array<Option, 4> options = {
    {{"whole faces", vtkSilhouettePass::TECHNIQUE_FACES, false, false},
     {"large split", vtkSilhouettePass::TECHNIQUE_FACES, true, false},
     {"flat left out too", vtkSilhouettePass::TECHNIQUE_FACES, true, true},
     {"rectangles", vtkSilhouettePass::TECHNIQUE_RECTANGLES, true, true}}};

Mesh makeCube()
{
  vtkNew<vtkCubeSource> cube;
  return clean(cube);
}

/// @param zoom  1: the mesh fills the view
void compareOn(const std::string& what, const Mesh& mesh, double zoom, int rounds, int width, int height)
{
  if (!mesh)
  {
    return;
  }
  const auto drawer = makePassDrawer(mesh, width, height);
  auto* pass = vtkSilhouettePass::SafeDownCast(drawer->getRenderer()->GetPass());
  vtkCamera* camera = drawer->getRenderer()->GetActiveCamera();
  camera->SetPosition(0.4, 0.5, 1.0);
  drawer->getRenderer()->ResetCamera();
  camera->Dolly(zoom);
  drawer->getRenderer()->ResetCameraClippingRange();
  drawer->setLineWidth(4.0);
  pass->SetDepthScale(1);
  pass->MeasureStagesOn();
  std::array<std::vector<double>, options.size()> times;
  std::array<long long, options.size()> triangles{};
  for (int round = 0; round < rounds; ++round)
  {
    for (std::size_t i = 0; i < options.size(); ++i)
    {
      pass->SetTechnique(options[i].technique);
      pass->SetSplitLargeFaces(options[i].split);
      pass->SetLeaveOutFlatFaces(options[i].leaveOut);
      for (int frame = 0; frame < 3; ++frame)
      {
        drawer->drawNext();
        times[i].push_back(pass->GetEdgeMilliseconds() + pass->GetLineMilliseconds());
        triangles[i] = pass->GetLineTriangles();
      }
    }
  }
  std::printf("  %-24s %7lld", what.c_str(), static_cast<long long>(mesh->GetNumberOfPolys()));
  for (std::size_t i = 0; i < options.size(); ++i)
  {
    std::printf("  %7.2f ms %7lld", median(times[i]), triangles[i]);
  }
  std::printf("\n");
}

} // namespace

void compareFaceOptions(int rounds, int width, int height)
{
  std::printf("\nTECHNIQUE_FACES, lines of 4 pixels: edges and lines, and triangles drawn for them\n  %-32s",
              "");
  for (const Option& option : options)
  {
    std::printf("  %-18s", option.name);
  }
  std::printf("\n");
  compareOn("cube", makeCube(), 1.0, rounds, width, height);
  compareOn("cube, close", makeCube(), 1.6, rounds, width, height);
  compareOn("cube, each face divided", refineMesh(makeCube(), 12288), 1.0, rounds, width, height);
  compareOn("fandisk, close", readModel("fandisk"), 3.0, rounds, width, height);
  compareOn("teapot, close", readModel("teapot"), 3.0, rounds, width, height);
  compareOn("rings", makeRings(), 1.3, rounds, width, height);
}

} // namespace shadow::benchmarks
