#include "FigureMeasurement.h"

#include <stdexcept>

#include "SilhouetteFinder.h"
#include "Timing.h"

namespace shadow::benchmarks
{

namespace
{

/// Frames after a change of method that do not count: shaders, buffers and prepared data come with them.
constexpr int warmUpFrames = 2;

/// All values of one method at one point.
struct Series
{
  std::vector<double> milliseconds;
  std::vector<double> scene;
  std::vector<double> silhouette;
  std::vector<double> readBack;
  std::vector<double> prePass;
  std::vector<double> stencil;
  std::vector<double> lighting;
};

void drawStages(FigureScene& scene, Series& series)
{
  vtkShadowVolumePass* pass = scene.scene.pass;
  pass->MeasureStagesOn();
  scene.draw();
  pass->MeasureStagesOff();
  series.scene.push_back(pass->GetSceneMilliseconds());
  series.silhouette.push_back(pass->GetSilhouetteMilliseconds());
  series.readBack.push_back(pass->GetReadBackMilliseconds());
  series.prePass.push_back(pass->GetPrePassMilliseconds());
  series.stencil.push_back(pass->GetStencilMilliseconds());
  series.lighting.push_back(pass->GetLightingMilliseconds());
}

void takeTurn(FigureScene& scene, const FigureMethod& method, int frames, int& frame, Series& series)
{
  vtkShadowVolumePass* pass = scene.scene.pass;
  const bool shadows = method.silhouette != FigureMethod::withoutShadows;
  scene.scene.renderer->SetPass(shadows ? pass : nullptr);
  if (shadows)
  {
    pass->SetSilhouetteMethod(method.silhouette);
  }
  for (int i = 0; i < warmUpFrames + frames; ++i)
  {
    scene.moveLights(frame++);
    const double milliseconds = scene.draw();
    if (i >= warmUpFrames)
    {
      series.milliseconds.push_back(milliseconds);
    }
  }
  scene.moveLights(frame++);
  if (shadows)
  {
    drawStages(scene, series);
  }
}

void takeMedians(const Series& series, FigureSample& sample)
{
  sample.milliseconds = median(series.milliseconds);
  sample.scene = median(series.scene);
  sample.silhouette = median(series.silhouette);
  sample.readBack = median(series.readBack);
  sample.prePass = median(series.prePass);
  sample.stencil = median(series.stencil);
  sample.lighting = median(series.lighting);
}

void count(vtkShadowVolumePass* pass, FigureSample& sample)
{
  if (pass->GetStatus() == vtkShadowVolumePass::STATUS_NOT_SUPPORTED)
  {
    throw std::runtime_error(pass->GetStatusMessage());
  }
  sample.sceneTriangles = pass->GetAmbientTriangles();
  sample.sideTriangles = pass->GetSideTriangles();
  sample.drawnTriangles = pass->GetTotalTriangles();
  sample.message = pass->GetStatusMessage();
}

} // namespace

std::vector<FigureMethod> allFigureMethods()
{
  vtkNew<vtkShadowVolumePass> pass;
  std::vector<FigureMethod> methods{{"no-shadows"}};
  for (int i = pass->GetSilhouetteMethodMinValue(); i <= pass->GetSilhouetteMethodMaxValue(); ++i)
  {
    const std::string name = toString(static_cast<SilhouetteMethod>(i));
    if (name != "auto")
    {
      methods.push_back({name, i});
    }
  }
  return methods;
}

std::vector<FigureSample> measureFigurePoint(FigureScene& scene, const std::vector<FigureMethod>& methods,
                                             int stencilMethod, const FigureEffort& effort)
{
  vtkShadowVolumePass* pass = scene.scene.pass;
  pass->SetStencilMethod(stencilMethod);
  std::vector<Series> series(methods.size());
  std::vector<FigureSample> samples(methods.size());
  for (int round = 0; round < effort.rounds; ++round)
  {
    for (std::size_t i = 0; i < methods.size(); ++i)
    {
      // Every method sees the lights of a round where all others see them.
      int frame = round * (warmUpFrames + effort.frames + 1);
      takeTurn(scene, methods[i], effort.frames, frame, series[i]);
      if (methods[i].silhouette != FigureMethod::withoutShadows)
      {
        count(pass, samples[i]);
      }
    }
  }
  for (std::size_t i = 0; i < methods.size(); ++i)
  {
    takeMedians(series[i], samples[i]);
  }
  return samples;
}

} // namespace shadow::benchmarks
