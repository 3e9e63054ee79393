// The mask of the last rendering is used again while it is right, and made anew where it is not.

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkDataObject.h>
#include <vtkDataSetAttributes.h>
#include <vtkImageData.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPoints.h>
#include <vtkTexture.h>

#include "ExcludingCuller.h"
#include "KeptScene.h"

using namespace shadow::test;
using namespace shadow::truth;

namespace
{

using Pass = vtkShadowVolumePass;

struct Change
{
  std::string name;
  int kept; ///< lights whose part of the mask is still right afterwards
  std::function<void(KeptScene&)> apply;
};

void movePoints(vtkPolyData* mesh)
{
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double point[3];
    mesh->GetPoint(i, point);
    mesh->GetPoints()->SetPoint(i, point[0] + 0.2, 1.3 * point[1], point[2]);
  }
}

void dropHalfOfTheCells(vtkPolyData* mesh)
{
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPolys() / 2; ++i)
  {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    mesh->GetPolys()->GetCellAtId(i, count, corners);
    cells->InsertNextCell(count, corners);
  }
  mesh->SetPolys(cells);
}

vtkSmartPointer<vtkTexture> makeTranslucentTexture()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 16, static_cast<unsigned char>(100));
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  return texture;
}

std::vector<Change> listSceneChanges()
{
  return {
      {"source's parameter", 0, [](KeptScene& s) { s.source->SetRadius(0.7); }},
      {"points in place", 0, [](KeptScene& s) { movePoints(s.points), s.points->GetPoints()->Modified(); }},
      {"points in place, data set modified", 0, [](KeptScene& s) { movePoints(s.points), s.points->Modified(); }},
      {"cells", 0, [](KeptScene& s) { dropHalfOfTheCells(s.points); }},
      {"position", 0, [](KeptScene& s) { s.ball->SetPosition(0.3, 0.2, 0.0); }},
      {"orientation", 0, [](KeptScene& s) { s.composite->RotateY(20.0); }},
      {"scale that mirrors", 0, [](KeptScene& s) { s.ball->SetScale(-0.8, 1.0, 1.0); }},
      {"user transform", 0, [](KeptScene& s) { s.user->Translate(-0.3, 0.0, 0.2); }},
      {"assembly", 0, [](KeptScene& s) { s.outer->SetPosition(-0.4, 0.1, 0.0); }},
      {"assembly in an assembly", 0, [](KeptScene& s) { s.inner->RotateZ(15.0); }},
      {"part added", 0, [](KeptScene& s) { s.inner->AddPart(s.ball); }},
      {"part removed", 0, [](KeptScene& s) { s.inner->RemovePart(s.part); }},
      {"actor removed", 0, [](KeptScene& s) { s.renderer->RemoveActor(s.ball); }},
      {"actor hidden", 0, [](KeptScene& s) { s.ball->VisibilityOff(); }},
      {"assembly hidden", 0, [](KeptScene& s) { s.inner->VisibilityOff(); }},
      {"opacity", 0, [](KeptScene& s) { s.ball->GetProperty()->SetOpacity(0.5); }},
      {"texture that is translucent", 0, [](KeptScene& s) { s.ball->SetTexture(makeTranslucentTexture()); }},
      {"representation", 0, [](KeptScene& s) { s.ball->GetProperty()->SetRepresentationToWireframe(); }},
      {"culling", 0, [](KeptScene& s) { s.ball->GetProperty()->FrontfaceCullingOn(); }},
      {"property replaced", 0,
       [](KeptScene& s)
       {
         vtkNew<vtkProperty> culling;
         culling->BackfaceCullingOn();
         s.points->GetPolys()->Modified();
         s.pointsActor->SetProperty(culling);
       }},
      {"mapper replaced", 0, [](KeptScene& s) { s.ball->SetMapper(s.part->GetMapper()); }},
      {"clipping plane moved", 0, [](KeptScene& s) { s.clippingPlane->SetOrigin(1.0, 0.75, 0.8); }},
      {"clipping planes that are older than the mesh", 0,
       [](KeptScene& s)
       {
         vtkNew<vtkPlaneCollection> planes;
         vtkNew<vtkPlane> plane;
         plane->SetOrigin(1.0, 0.7, 0.8);
         plane->SetNormal(0.0, 1.0, 0.3);
         planes->AddItem(plane);
         s.clipped->GetMapper()->GetInputDataObject(0, 0)->Modified();
         s.window->Render();
         s.clipped->GetMapper()->SetClippingPlanes(planes);
       }},
      {"clipping planes removed", 0, [](KeptScene& s) { s.clipped->GetMapper()->RemoveAllClippingPlanes(); }},
      {"block hidden", 0,
       [](KeptScene& s)
       {
         s.blockMapper->GetCompositeDataDisplayAttributes()->SetBlockVisibility(s.blocks->GetBlock(0), false);
         s.blockMapper->Modified();
       }},
      {"block translucent", 0,
       [](KeptScene& s)
       {
         s.blockMapper->GetCompositeDataDisplayAttributes()->SetBlockOpacity(s.blocks->GetBlock(1), 0.4);
         s.blockMapper->Modified();
       }},
      {"block removed", 0, [](KeptScene& s) { s.blocks->SetBlock(0, nullptr); }},
      {"actor that does not cast", 0, [](KeptScene& s) { s.pass->SetCasting(s.ball, false); }},
      {"assembly that does not cast", 0, [](KeptScene& s) { s.pass->SetCasting(s.outer, false); }},
      {"weld tolerance", 0,
       [](KeptScene& s)
       {
         s.pass->SetSilhouetteMethodToHybrid();
         s.pass->SetWeldTolerance(0.3);
       }},
      {"coplanar tolerance", 0,
       [](KeptScene& s)
       {
         s.pass->SetSilhouetteMethodToHybrid();
         s.pass->SetCoplanarTolerance(40.0);
       }},
      {"camera", 0, [](KeptScene& s) { s.renderer->GetActiveCamera()->Azimuth(10.0); }},
      {"parallel view", 0, [](KeptScene& s) { s.renderer->GetActiveCamera()->ParallelProjectionOn(); }},
      {"window's size", 0, [](KeptScene& s) { s.window->SetSize(70, 80); }},
      {"window's size in the same shape", 0, [](KeptScene& s) { s.window->SetSize(180, 140); }},
      {"left out by VTK's cullers", 0,
       [](KeptScene& s)
       {
         vtkNew<ExcludingCuller> culler;
         culler->excluded = s.ball;
         s.renderer->AddCuller(culler);
       }},
      {"viewport", 0, [](KeptScene& s) { s.renderer->SetViewport(0.2, 0.0, 0.9, 0.8); }},
      {"samples", 0, [](KeptScene& s) { s.pass->SetSamples(4); }},
      {"point light moved", 2, [](KeptScene& s) { s.lights[0]->SetPosition(0.5, 4.0, 1.5); }},
      {"directional light turned", 2, [](KeptScene& s) { s.lights[1]->SetPosition(1.0, 2.0, 0.5); }},
      {"light made directional", 2, [](KeptScene& s) { s.lights[2]->SetPositional(false); }},
      {"two lights moved", 1,
       [](KeptScene& s)
       {
         s.lights[0]->SetPosition(0.5, 4.0, 1.5);
         s.lights[2]->SetPosition(-2.0, 2.0, -0.5);
       }},
      {"last light off", 2, [](KeptScene& s) { s.lights[2]->SwitchOff(); }},
      {"first light off, others change their places", 2, [](KeptScene& s) { s.lights[0]->SwitchOff(); }},
      {"light removed", 2, [](KeptScene& s) { s.renderer->RemoveLight(s.lights[1]); }},
      {"light added", 3, [](KeptScene& s) { s.addPointLight(0.0, 5.0, 0.0); }},
      {"headlight in the place of a light", 2, [](KeptScene& s) { s.lights[1]->SetLightTypeToHeadlight(); }},
      {"all lights off", 0,
       [](KeptScene& s)
       {
         for (vtkLight* light : s.lights)
         {
           light->SwitchOff();
         }
       }}};
}

/// Of what a mask does not depend on.
std::vector<Change> listOtherChanges()
{
  return {
      {"nothing", 3, [](KeptScene&) {}},
      {"light's cone", 3, [](KeptScene& s) { s.lights[0]->SetConeAngle(25.0); }},
      {"light's colour", 3, [](KeptScene& s) { s.lights[1]->SetColor(1.0, 0.4, 0.2); }},
      {"actor's colour", 3, [](KeptScene& s) { s.ball->GetProperty()->SetColor(1.0, 0.3, 0.2); }},
      {"actor's lighting", 3, [](KeptScene& s) { s.ball->GetProperty()->LightingOff(); }},
      {"shadow intensity", 3, [](KeptScene& s) { s.pass->SetShadowIntensity(0.5); }},
      {"compositing", 3, [](KeptScene& s) { s.pass->SetCompositingToAdditive(); }},
      {"background", 3, [](KeptScene& s) { s.renderer->SetBackground(0.1, 0.2, 0.3); }}};
}

/// What the pass draws after a change is what one draws that has seen nothing before it.
void expectRight(const Change& change, int method, int samples)
{
  SCOPED_TRACE(change.name + ", method " + std::to_string(method) + ", " + std::to_string(samples) + " samples");
  KeptScene scene;
  scene.pass->SetSilhouetteMethod(method);
  scene.pass->SetSamples(samples);
  scene.window->Render();
  EXPECT_EQ(scene.pass->GetNumberOfKeptLights(), 0);
  const DrawnShadows before = drawShadows(scene.window, scene.pass);
  EXPECT_EQ(scene.pass->GetNumberOfKeptLights(), KeptScene::lightCount);

  change.apply(scene);
  const DrawnShadows after = drawShadows(scene.window, scene.pass);
  EXPECT_EQ(scene.pass->GetNumberOfKeptLights(), change.kept);
  EXPECT_EQ(tellDifferences(after, drawByNewPass(scene.window, scene.pass)), "");
  EXPECT_TRUE(change.name == "nothing" || tellDifferences(after, before) != "") << "it shows nowhere";

  EXPECT_EQ(tellDifferences(drawShadows(scene.window, scene.pass), after), "");
  EXPECT_EQ(scene.pass->GetNumberOfKeptLights(), scene.pass->GetNumberOfShadowLights());
}

} // namespace

TEST(KeptMask, AnyChangeOfTheScene_AsDrawnByANewPass)
{
  for (const Change& change : listSceneChanges())
  {
    expectRight(change, Pass::SILHOUETTE_AUTO, 1);
  }
}

TEST(KeptMask, AnyChangeOfTheScene_OnTheGPU_AsDrawnByANewPass)
{
  for (const Change& change : listSceneChanges())
  {
    if (change.name.find("tolerance") == std::string::npos)
    {
      expectRight(change, Pass::SILHOUETTE_FACING_TEXTURE_RESIDENT, 1);
    }
  }
}

TEST(KeptMask, AnyChangeOfLights_ByEveryMethodOnTheGPU_AsDrawnByANewPass)
{
  for (const Change& change : listSceneChanges())
  {
    if (change.name.find("light") == std::string::npos)
    {
      continue;
    }
    for (int method = Pass::SILHOUETTE_FACING_TEXTURE; method <= Pass::SILHOUETTE_COMPUTE; ++method)
    {
      expectRight(change, method, method % 2 == 0 ? 1 : 4);
    }
  }
}

TEST(KeptMask, WhatItDoesNotDependOn_KeptForAllLights)
{
  for (const Change& change : listOtherChanges())
  {
    expectRight(change, Pass::SILHOUETTE_AUTO, 1);
  }
}

TEST(KeptMask, EveryMethodAfterEveryOther_NotKept)
{
  KeptScene scene;
  const DrawnShadows expected = drawShadows(scene.window, scene.pass);
  for (int method = Pass::SILHOUETTE_COMPUTE; method >= Pass::SILHOUETTE_AUTO; --method)
  {
    scene.pass->SetSilhouetteMethod(method);
    scene.window->Render();
    EXPECT_EQ(scene.pass->GetNumberOfKeptLights(), 0) << method;
    EXPECT_EQ(drawShadows(scene.window, scene.pass).masks, expected.masks) << method;
    EXPECT_EQ(scene.pass->GetNumberOfKeptLights(), KeptScene::lightCount) << method;
  }
}

TEST(KeptMask, CountBufferAndStencilMethod_NotKept)
{
  KeptScene scene;
  const DrawnShadows expected = drawShadows(scene.window, scene.pass);
  for (const int stencil : {Pass::STENCIL_ZPASS, Pass::STENCIL_ZFAIL, Pass::STENCIL_AUTO})
  {
    for (const int buffer : {Pass::COUNT_STENCIL, Pass::COUNT_COLOR})
    {
      scene.pass->SetStencilMethod(stencil);
      scene.pass->SetCountBuffer(buffer);
      EXPECT_EQ(drawShadows(scene.window, scene.pass).masks, expected.masks);
      EXPECT_EQ(scene.pass->GetNumberOfKeptLights(), 0);
      scene.lights[1]->SetPosition(-0.3, 1.0, 0.1);
      const DrawnShadows moved = drawShadows(scene.window, scene.pass);
      EXPECT_EQ(tellDifferences(moved, drawByNewPass(scene.window, scene.pass)), "");
      scene.lights[1]->SetPosition(-0.4, 1.0, 0.2);
      EXPECT_EQ(drawShadows(scene.window, scene.pass).masks, expected.masks);
      EXPECT_EQ(scene.pass->GetNumberOfKeptLights(), KeptScene::lightCount - 1);
    }
  }
}
