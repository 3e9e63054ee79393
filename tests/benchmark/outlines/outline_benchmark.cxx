// Outlines: what the lines cost beside pass 1 and beside other ways of drawing them, and how many of their
// pixels are wrong.
//
//   bench_outlines [--rounds N] [--size WxH]
//
// The camera goes round the mesh, so that edges are found anew in every frame. Medians; all that is compared
// takes turns. The teapot and the bunny are taken from ../shared/models.

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <vtkCamera.h>
#include <vtkPolyData.h>
#include <vtkSilhouettePass.h>

#include "OutlineDrawers.h"
#include "OutlineError.h"
#include "OutlineFaceOptions.h"
#include "OutlineLayouts.h"
#include "OutlineMeshes.h"
#include "OutlineTruth.h"
#include "RefinedMesh.h"
#include "SceneFromRenderer.h"
#include "Timing.h"

namespace
{

using namespace shadow::benchmarks;
using shadow::truth::OutlineError;
using shadow::truth::OutlineTruth;

struct Effort
{
  int rounds = 9;
  int framesATurn = 3;
  int width = 640;
  int height = 480;
};

void lookAt(OutlineDrawer& drawer)
{
  vtkCamera* camera = drawer.getRenderer()->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(0.4, 0.5, 1.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  drawer.getRenderer()->ResetCamera();
  camera->Dolly(1.3);
  drawer.getRenderer()->ResetCameraClippingRange();
}

OutlineTruth makeTruth(OutlineDrawer& drawer)
{
  drawer.readLines();
  return OutlineTruth(shadow::truth::sceneFromRenderer(drawer.getRenderer()),
                      shadow::truth::viewFromRenderer(drawer.getRenderer()));
}

/// What the stages of the pass take in one setting.
struct StageTimes
{
  double width = 0.0;
  int depthScale = 0; ///< see vtkSilhouettePass::SetDepthScale()
  int technique = vtkSilhouettePass::TECHNIQUE_RECTANGLES;
  std::vector<double> first, edges, lines, blend, frame;

  double getSecond() const { return median(this->edges) + median(this->lines) + median(this->blend); }
};

/// Every width with pass 1 as fine as the view, as the paper's is, and as fine as the pass has it by default;
/// the former also with the paper's own technique.
std::vector<StageTimes> makeSettings(const std::vector<double>& widths)
{
  constexpr int rectangles = vtkSilhouettePass::TECHNIQUE_RECTANGLES;
  constexpr int faces = vtkSilhouettePass::TECHNIQUE_FACES;
  std::vector<StageTimes> settings;
  for (const auto& [depthScale, technique] : {std::pair(1, rectangles), {0, rectangles}, {1, faces}})
  {
    for (const double width : widths)
    {
      settings.push_back({width, depthScale, technique, {}, {}, {}, {}, {}});
    }
  }
  return settings;
}

/// Stages in each setting and the plain frame, in turns.
void measureStages(const Mesh& mesh, const Effort& effort, std::vector<StageTimes>& times, double& plainFrame)
{
  const auto plain = makePlainDrawer(mesh, effort.width, effort.height);
  const auto outlined = makePassDrawer(mesh, effort.width, effort.height);
  auto* pass = vtkSilhouettePass::SafeDownCast(outlined->getRenderer()->GetPass());
  std::vector<double> plainFrames;
  lookAt(*plain);
  lookAt(*outlined);
  for (int round = 0; round < effort.rounds; ++round)
  {
    plain->drawNext();
    for (int frame = 0; frame < effort.framesATurn; ++frame)
    {
      plainFrames.push_back(plain->drawNext());
    }
    for (StageTimes& some : times)
    {
      outlined->setLineWidth(some.width);
      pass->SetDepthScale(some.depthScale);
      pass->SetTechnique(some.technique);
      pass->MeasureStagesOff();
      outlined->drawNext();
      for (int frame = 0; frame < effort.framesATurn; ++frame)
      {
        some.frame.push_back(outlined->drawNext());
      }
      pass->MeasureStagesOn();
      for (int frame = 0; frame < effort.framesATurn; ++frame)
      {
        outlined->drawNext();
        some.first.push_back(pass->GetDepthMilliseconds());
        some.edges.push_back(pass->GetEdgeMilliseconds());
        some.lines.push_back(pass->GetLineMilliseconds());
        some.blend.push_back(pass->GetBlendMilliseconds());
      }
    }
  }
  plainFrame = median(plainFrames);
}

/// A ratio of the paper, and what is aimed at.
std::string describePaper(double width)
{
  const double ratio = width == 2.0 ? 4.7 : width == 6.0 ? 8.8 : 0.0;
  char text[64] = "";
  if (ratio > 0.0)
  {
    std::snprintf(text, sizeof text, "%5.1f  %4.2f", ratio, 0.5 * ratio);
  }
  return text;
}

void compareStages(const std::string& what, const Mesh& mesh, const std::vector<double>& widths,
                   const Effort& effort)
{
  std::vector<StageTimes> times = makeSettings(widths);
  double plain = 0.0;
  measureStages(mesh, effort, times, plain);
  std::printf("\n%s, %lld triangles; plain VTK %.2f ms a frame\n", what.c_str(),
              static_cast<long long>(mesh->GetNumberOfPolys()), plain);
  std::printf("technique   pass 1        width  pass 1  pass 2  (edges  lines  blend)  pass 2 : 1  paper   "
              "aim    frame\n");
  for (const StageTimes& some : times)
  {
    const double first = median(some.first);
    std::printf("%-10s  %-12s  %5g  %6.2f  %6.2f  (%5.2f  %5.2f  %5.2f)  %10.2f  %-11s  %7.2f\n",
                some.technique == vtkSilhouettePass::TECHNIQUE_FACES ? "faces" : "rectangles",
                some.depthScale == 1 ? "as the view" : "default", some.width, first, some.getSecond(),
                median(some.edges), median(some.lines), median(some.blend), some.getSecond() / first,
                describePaper(some.width).c_str(), median(some.frame));
  }
}

/// Certain line pixels that are not drawn, and drawn ones that are no line.
std::size_t countWrong(const OutlineError& error)
{
  return error.missing + error.extra;
}

/// Of what draws lines of no width in particular: the width that fits it best.
void printBestWidth(const OutlineTruth& truth, const std::vector<unsigned char>& lines)
{
  constexpr int widest = 8;
  int best = 1;
  for (int width = 2; width <= widest; ++width)
  {
    if (countWrong(compareOutline(truth, lines, width)) < countWrong(compareOutline(truth, lines, best)))
    {
      best = width;
    }
  }
  const OutlineError error = compareOutline(truth, lines, best);
  std::printf("; held against %d pixels, where it is best, %zu of %zu missing, %zu of %zu no line", best,
              error.missing, error.certain, error.extra, error.drawn);
}

/// Holds lines against the truth. A pixel is drawn when it has changed by half or more from the picture
/// without lines, in colours made for that.
void judge(OutlineDrawer& drawer, double width)
{
  const OutlineTruth truth = makeTruth(drawer);
  drawer.useMaskColours();
  const std::vector<unsigned char> lines = drawer.readLines();
  const OutlineError error = compareOutline(truth, lines, width);
  std::printf("; %5zu wrong: %5zu of %5zu certain line pixels missing, %5zu of %5zu drawn are no line",
              countWrong(error), error.missing, error.certain, error.extra, error.drawn);
  if (!drawer.hasLineWidth())
  {
    printBestWidth(truth, lines);
  }
}

void compareDrawers(const std::string& what, const Mesh& mesh, double width, const Effort& effort)
{
  const auto makers = {&makePlainDrawer, &makePassDrawer, &makeFilterDrawer, &makeGlowDrawer};
  std::vector<std::unique_ptr<OutlineDrawer>> drawers;
  for (const auto maker : makers)
  {
    drawers.push_back(maker(mesh, effort.width, effort.height));
    drawers.back()->setLineWidth(width);
    lookAt(*drawers.back());
  }
  std::vector<std::vector<double>> times(drawers.size());
  for (int round = 0; round < effort.rounds; ++round)
  {
    for (std::size_t i = 0; i < drawers.size(); ++i)
    {
      drawers[i]->drawNext();
      for (int frame = 0; frame < effort.framesATurn; ++frame)
      {
        times[i].push_back(drawers[i]->drawNext());
      }
    }
  }
  std::printf("\n%s, %lld triangles, lines of %g pixels\n", what.c_str(),
              static_cast<long long>(mesh->GetNumberOfPolys()), width);
  for (std::size_t i = 0; i < drawers.size(); ++i)
  {
    std::printf("  %-22s %7.2f ms a frame", drawers[i]->getName().c_str(), median(times[i]));
    if (i > 0)
    {
      lookAt(*drawers[i]);
      judge(*drawers[i], width);
    }
    std::printf("\n");
  }
}

bool readArguments(int argc, char** argv, Effort& effort)
{
  for (int i = 1; i < argc; i += 2)
  {
    const bool hasValue = i + 1 < argc;
    if (hasValue && std::strcmp(argv[i], "--rounds") == 0 && std::atoi(argv[i + 1]) > 0)
    {
      effort.rounds = std::atoi(argv[i + 1]);
    }
    else if (!hasValue || std::strcmp(argv[i], "--size") != 0 ||
             std::sscanf(argv[i + 1], "%dx%d", &effort.width, &effort.height) != 2 || effort.width < 1 ||
             effort.height < 1)
    {
      return false;
    }
  }
  return true;
}

} // namespace

int main(int argc, char** argv)
{
  Effort effort;
  if (!readArguments(argc, argv, effort))
  {
    std::fprintf(stderr, "usage: bench_outlines [--rounds N] [--size WxH]\n");
    return 2;
  }
  std::printf("%d x %d pixels, median of %d rounds of %d frames, milliseconds\n", effort.width, effort.height,
              effort.rounds, effort.framesATurn);
  printLayouts();
  compareFaceOptions(effort.rounds, effort.width, effort.height);
  const Mesh rings = makeRings();
  compareStages("Valient's 30,000 visible polygons: twelve rings", rings, {2.0, 6.0}, effort);
  const Mesh model = readModel("teapot");
  const Mesh teapot = model ? refineMesh(model, 9217) : nullptr;
  if (teapot)
  {
    compareStages("Valient's figure 4: teapot", teapot, {2.0, 4.0, 8.0}, effort);
  }
  for (const double width : {2.0, 4.0})
  {
    compareDrawers("rings", rings, width, effort);
    if (teapot)
    {
      compareDrawers("teapot", teapot, width, effort);
    }
    if (const Mesh bunny = readModel("stanford-bunny"))
    {
      compareDrawers("stanford-bunny", bunny, width, effort);
    }
  }
  return 0;
}
