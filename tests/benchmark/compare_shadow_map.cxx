// A scene drawn with vtkShadowMapPass (left) and with shadow volumes (right), and how many of the lit pixels
// each gets wrong against ray-cast truth.
//
//   compare_shadow_map [MODEL.obj] [--output picture.png]      without a model: spheres and a torus

#include <cstdio>
#include <string>
#include <vector>

#include <vtkActorCollection.h>
#include <vtkCameraPass.h>
#include <vtkImageData.h>
#include <vtkOBJReader.h>
#include <vtkPNGWriter.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>

#include "MaskTruth.h"
#include "RayCaster.h"
#include "SceneFromRenderer.h"
#include "ShadowMap.h"
#include "ShadowScene.h"

namespace
{

using namespace shadow::truth;
using Picture = std::vector<unsigned char>; ///< RGB, bottom row first

/// Pixels of a window. vtkShadowMapPass is at its best in a square one.
struct Size
{
  int width;
  int height;
};

void addModel(ShadowScene& scene, const std::string& model)
{
  if (!model.empty())
  {
    vtkNew<vtkOBJReader> reader;
    reader->SetFileName(model.c_str());
    scene.addSource(reader);
    return;
  }
  vtkNew<vtkParametricTorus> torus;
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(torus);
  source->SetUResolution(60);
  source->SetVResolution(60);
  scene.addSource(source)->RotateX(60.0);
  for (const double x : {-0.9, 0.9})
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(0.35);
    sphere->SetCenter(x, 1.4, 0.3);
    sphere->SetThetaResolution(48);
    sphere->SetPhiResolution(48);
    scene.addSource(sphere);
  }
}

/// Share of the certain pixels lit by the unshadowed scene that are dark in the picture and should not be, or
/// the other way round; in percent. @pre nothing is lit but by the light
double wrongPercent(const Picture& lit, const Picture& shadowed, const MaskTruth& truth, const Size& size)
{
  std::size_t seen = 0;
  std::size_t wrong = 0;
  for (int y = 0; y < size.height; ++y)
  {
    for (int x = 0; x < size.width; ++x)
    {
      const auto pixel = static_cast<std::size_t>(y * size.width + x);
      const int before = lit[3 * pixel];
      if (before < 20 || !truth.isCertain(x, y))
      {
        continue;
      }
      ++seen;
      const bool dark = 2 * shadowed[3 * pixel] < before;
      wrong += dark != (truth.mask()[pixel] == 0) ? 1 : 0;
    }
  }
  return seen > 0 ? 100.0 * static_cast<double>(wrong) / static_cast<double>(seen) : 0.0;
}

void setAmbient(ShadowScene& scene, double ambient)
{
  vtkActorCollection* actors = scene.renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
  {
    actor->GetProperty()->SetAmbient(ambient);
  }
}

Picture drawWith(ShadowScene& scene, vtkRenderPass* pass)
{
  scene.renderer->SetPass(pass);
  return scene.renderPicture();
}

void writeSideBySide(const Picture& left, const Picture& right, const Size& size, const std::string& path)
{
  const int width = size.width;
  const int height = size.height;
  vtkNew<vtkImageData> image;
  image->SetDimensions(2 * width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < height; ++y)
  {
    auto* row = static_cast<unsigned char*>(image->GetScalarPointer(0, y, 0));
    std::copy_n(left.begin() + 3 * y * width, 3 * width, row);
    std::copy_n(right.begin() + 3 * y * width, 3 * width, row + 3 * width);
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(image);
  writer->Write();
}

/// Draws and measures in one window; writes the picture.
void compareIn(const Size& size, const std::string& model, const std::string& output)
{
  ShadowScene scene(size.width, size.height);
  scene.renderer->SetBackground(0.0, 0.0, 0.0);
  addModel(scene, model);
  double bounds[6];
  scene.renderer->ComputeVisiblePropBounds(bounds);
  const double modelHeight = bounds[3] - bounds[2];
  scene.addFloor();
  scene.lookFrom(-0.4, 0.7, 1.0, 0.8);
  // What both can do: a spot light below 90 degrees. Only what lies inside its cone, and so inside the shadow
  // map, is lit.
  vtkLight* light =
      scene.addPointLight(0.5 * (bounds[0] + bounds[1]) + 0.9 * modelHeight, bounds[3] + 1.2 * modelHeight,
                          0.5 * (bounds[4] + bounds[5]) + 0.7 * modelHeight);
  light->SetFocalPoint(0.5 * (bounds[0] + bounds[1]), bounds[2], 0.5 * (bounds[4] + bounds[5]));
  light->SetConeAngle(40.0);
  light->SetExponent(0.0);

  vtkNew<vtkCameraPass> shadowMap;
  useShadowMap(shadowMap);

  setAmbient(scene, 0.0);
  const Picture volumes = drawWith(scene, scene.pass);
  const RayCaster caster(sceneFromRenderer(scene.renderer));
  const MaskTruth truth(caster, viewFromRenderer(scene.renderer),
                        lightsFromRenderer(scene.renderer)[0].light);

  const Picture lit = drawWith(scene, nullptr);
  const Picture mapped = drawWith(scene, shadowMap);
  std::printf(
      "%d x %d, wrong lit pixels: vtkShadowMapPass (2048 x 2048) %.3f %%, vtkShadowVolumePass %.4f %%\n",
      size.width, size.height, wrongPercent(lit, mapped, truth, size),
      wrongPercent(lit, volumes, truth, size));

  setAmbient(scene, 0.15);
  writeSideBySide(drawWith(scene, shadowMap), drawWith(scene, scene.pass), size, output);
  shadowMap->ReleaseGraphicsResources(scene.window);
}

} // namespace

int main(int argc, char** argv)
{
  std::string model;
  std::string output = "compare_shadow_map.png";
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if (argument == "--output" && i + 1 < argc)
    {
      output = argv[++i];
    }
    else
    {
      model = argument;
    }
  }
  compareIn({480, 480}, model, output);
  compareIn({640, 480}, model, output);
  std::printf("picture (shadow map left, shadow volumes right): %s\n", output.c_str());
  return 0;
}
