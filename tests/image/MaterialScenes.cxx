// Scenes about materials and about how a picture is put together.

#include <vtkCamera.h>
#include <vtkElevationFilter.h>
#include <vtkImageData.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkSilhouettePass.h>
#include <vtkSphereSource.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTexture.h>

#include "ImageScenes.h"

namespace shadow::test
{

namespace
{

vtkSmartPointer<vtkTexture> makeChequers()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(16, 16, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < 16; ++y)
  {
    for (int x = 0; x < 16; ++x)
    {
      auto* colour = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      const bool dark = (x + y) % 2 == 0;
      colour[0] = dark ? 150 : 240;
      colour[1] = dark ? 170 : 235;
      colour[2] = dark ? 140 : 220;
    }
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  return texture;
}

} // namespace

void makeAdditive(truth::ShadowScene& scene)
{
  const StillLife stillLife(scene);
  scene.addPointLight(-2.0, 3.5, 2.0)->SetIntensity(0.6);
  scene.addDirectionalLight(-0.6, -1.0, -0.8)->SetIntensity(0.5);
  scene.pass->SetCompositingToAdditive();
}

void makePhysicallyBased(truth::ShadowScene& scene)
{
  const StillLife stillLife(scene);
  for (vtkActor* actor : {stillLife.ring, stillLife.block, stillLife.cone, stillLife.floor})
  {
    actor->GetProperty()->SetInterpolationToPBR();
    actor->GetProperty()->SetRoughness(0.55);
  }
  stillLife.ring->GetProperty()->SetMetallic(0.6);
  scene.addDirectionalLight(0.9, -1.0, -0.5)->SetIntensity(2.0);
}

void makeSmoothTexturedAndScalars(truth::ShadowScene& scene)
{
  const StillLife stillLife(scene);
  stillLife.ring->GetProperty()->SetInterpolationToPhong();
  stillLife.ring->GetProperty()->SetSpecular(0.4);
  stillLife.ring->GetProperty()->SetSpecularPower(25.0);
  stillLife.block->GetProperty()->SetInterpolationToFlat();
  stillLife.block->GetProperty()->EdgeVisibilityOn();
  vtkNew<vtkElevationFilter> elevation;
  elevation->SetInputConnection(stillLife.cone->GetMapper()->GetInputConnection(0, 0));
  elevation->SetLowPoint(0.0, -0.4, 0.0);
  elevation->SetHighPoint(0.0, 0.4, 0.0);
  stillLife.cone->GetMapper()->SetInputConnection(elevation->GetOutputPort());
  stillLife.floor->SetTexture(makeChequers());
  scene.addPointLight(-2.0, 3.5, 2.0);
}

void makeTranslucentAndOverlay(truth::ShadowScene& scene)
{
  const StillLife stillLife(scene);
  vtkNew<vtkSphereSource> glass;
  glass->SetCenter(0.1, 0.6, 1.2);
  glass->SetRadius(0.5);
  glass->SetThetaResolution(24);
  glass->SetPhiResolution(16);
  vtkActor* actor = scene.addSource(glass);
  actor->GetProperty()->SetColor(0.5, 0.9, 0.6);
  actor->GetProperty()->SetOpacity(0.4);
  vtkNew<vtkTextActor> text;
  text->SetInput("shadow volumes");
  text->SetPosition(12.0, 10.0);
  text->GetTextProperty()->SetFontSize(20);
  scene.renderer->AddViewProp(text);
  scene.addPointLight(-2.0, 3.5, 2.0);
}

void makeTwoViewports(truth::ShadowScene& scene)
{
  const StillLife stillLife(scene);
  vtkLight* light = scene.addPointLight(-2.0, 3.5, 2.0);
  scene.renderer->SetViewport(0.0, 0.0, 0.6, 1.0);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.6, 0.25, 1.0, 1.0);
  other->AutomaticLightCreationOff();
  other->SetBackground(0.2, 0.25, 0.2);
  for (vtkActor* actor : {stillLife.ring, stillLife.block, stillLife.cone, stillLife.floor})
  {
    other->AddActor(actor);
  }
  other->AddLight(light);
  other->SetPass(scene.pass);
  scene.window->AddRenderer(other);
  other->GetActiveCamera()->SetPosition(-4.0, 5.0, -3.0);
  other->GetActiveCamera()->SetFocalPoint(0.0, 0.2, 0.0);
  other->ResetCameraClippingRange();
}

void makeSamples(truth::ShadowScene& scene)
{
  const StillLife stillLife(scene);
  scene.addPointLight(-2.0, 3.5, 2.0);
  scene.pass->SetSamples(4);
}

void makeOutlinesOverShadows(truth::ShadowScene& scene)
{
  const StillLife stillLife(scene);
  scene.addPointLight(-2.0, 3.5, 2.0);
  vtkNew<vtkSilhouettePass> outlines;
  outlines->SetDelegatePass(scene.pass);
  outlines->SetLineWidth(3.0);
  outlines->SetColor(0.1, 0.05, 0.3);
  outlines->CreaseEdgesOn();
  outlines->SetFeatureAngle(50.0);
  outlines->HiddenEdgesOn();
  outlines->SetHiddenColor(0.9, 0.2, 0.2);
  outlines->SetHiddenOpacity(0.5);
  outlines->SetOutlined(stillLife.floor, false);
  scene.renderer->SetPass(outlines);
}

} // namespace shadow::test
