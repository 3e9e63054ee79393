// Windows of any shape, viewports, several renderers and windows, and objects that come and go.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include <vtkCamera.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include "BallScene.h"

using namespace shadow::test;

namespace
{

/// A second renderer with the same scene.
vtkSmartPointer<vtkRenderer> cloneRenderer(BallScene& scene)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->AutomaticLightCreationOff();
  renderer->AddActor(scene.ballActor);
  renderer->AddActor(scene.table);
  renderer->AddLight(scene.lamp);
  renderer->GetActiveCamera()->DeepCopy(scene.renderer->GetActiveCamera());
  renderer->SetBackground(scene.renderer->GetBackground());
  return renderer;
}

Pixels cut(const Pixels& picture, int width, int x, int y, int cutWidth, int cutHeight)
{
  Pixels result;
  for (int row = y; row < y + cutHeight; ++row)
  {
    const auto first = picture.begin() + 3 * (row * width + x);
    result.insert(result.end(), first, first + 3 * cutWidth);
  }
  return result;
}

} // namespace

TEST(PassWindow, AnyShape_MaskIsTheTruth)
{
  for (const auto& [width, height] :
       {std::pair<int, int>{400, 60}, {60, 400}, {200, 150}, {151, 149}, {1, 1}})
  {
    BallScene scene(width, height);
    const shadow::truth::MaskError error = scene.compare();
    EXPECT_EQ(error.pixels, static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    EXPECT_LE(error.wrongCertain, rimPixels) << width << " x " << height;
  }
}

TEST(PassWindow, StretchedAndOffCentreView_MaskIsTheTruth)
{
  BallScene scene;
  scene.renderer->GetActiveCamera()->SetWindowCenter(0.4, -0.2);
  EXPECT_LE(scene.compare().wrongCertain, rimPixels);
  scene.renderer->GetActiveCamera()->SetWindowCenter(0.0, 0.0);
  scene.renderer->GetActiveCamera()->SetUseExplicitAspectRatio(true);
  scene.renderer->GetActiveCamera()->SetExplicitAspectRatio(2.5);
  scene.renderer->GetActiveCamera()->SetUserTransform(nullptr);
  const Pixels stretched = scene.renderMask();
  EXPECT_GT(countValue(stretched, 0), 100u);
}

TEST(PassWindow, SubViewport_SameMaskAndPictureAsInOwnWindow)
{
  BallScene own(200, 150);
  BallScene part(400, 250);
  part.renderer->SetViewport(0.25, 0.2, 0.75, 0.8);
  for (const Use use : allUses)
  {
    attach(own.renderer, own.pass, use);
    attach(part.renderer, part.pass, use);
    const Pixels mask = own.renderMask();
    EXPECT_GT(countValue(mask, 0), 400u);
    EXPECT_LE(countDifferent(part.renderMask(), mask), 2u) << toString(use);
    const Pixels picture = cut(part.renderPicture(), 400, 100, 50, 200, 150);
    EXPECT_LE(countDifferent(picture, own.renderPicture(), 2), 12u) << toString(use);
  }
}

TEST(PassWindow, SeveralRenderers_SharedPassOrOwn_EachHasItsShadow)
{
  for (const bool shared : {true, false})
  {
    BallScene scene(400, 150);
    const vtkSmartPointer<vtkRenderer> second = cloneRenderer(scene);
    vtkNew<vtkShadowVolumePass> otherPass;
    second->SetPass(shared ? scene.pass.Get() : otherPass.Get());
    scene.window->AddRenderer(second);
    scene.renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
    second->SetViewport(0.5, 0.0, 1.0, 1.0);
    for (int frame = 0; frame < 3; ++frame)
    {
      const Pixels picture = scene.renderPicture();
      const Pixels left = cut(picture, 400, 0, 0, 200, 150);
      BallScene alone;
      EXPECT_LE(countDifferent(left, alone.renderPicture(), 2), 12u) << shared << " in frame " << frame;
      EXPECT_LE(countDifferent(cut(picture, 400, 200, 0, 200, 150), left, 2), 12u)
          << shared << " in frame " << frame;
    }
    EXPECT_EQ(scene.pass->GetNumberOfRebuiltVolumes(), 0);
  }
}

TEST(PassWindow, LayeredRenderer_KeepsItsShadow)
{
  BallScene scene;
  const Pixels before = scene.renderPicture();
  vtkNew<vtkRenderer> above;
  scene.window->SetNumberOfLayers(2);
  above->SetLayer(1);
  vtkNew<vtkShadowVolumePass> abovePass;
  above->SetPass(abovePass);
  scene.window->AddRenderer(above);
  EXPECT_EQ(countDifferent(scene.renderPicture(), before), 0u);
}

TEST(PassWindow, Resized_SameAsNewWindow)
{
  BallScene scene;
  scene.renderMask();
  for (const auto& [width, height] :
       {std::pair<int, int>{300, 100}, {80, 220}, {200, 150}, {640, 480}, {64, 64}})
  {
    scene.window->SetSize(width, height);
    BallScene fresh(width, height);
    EXPECT_EQ(scene.renderMask(), fresh.renderMask()) << width << " x " << height;
    EXPECT_EQ(countDifferent(scene.renderPicture(), fresh.renderPicture()), 0u) << width << " x " << height;
  }
}

TEST(PassWindow, TwoWindowsInTurn_OnePassEach_PicturesStay)
{
  BallScene first;
  BallScene second(160, 120);
  const Pixels firstPicture = first.renderPicture();
  const Pixels secondPicture = second.renderPicture();
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(countDifferent(first.renderPicture(), firstPicture), 0u);
    EXPECT_EQ(countDifferent(second.renderPicture(), secondPicture), 0u);
  }
}

TEST(PassWindow, TwoWindowsInTurn_OnePassForBoth_PicturesStay)
{
  BallScene first;
  BallScene second(160, 120);
  const Pixels firstPicture = first.renderPicture();
  const Pixels secondPicture = second.renderPicture();
  second.renderer->SetPass(first.pass);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(countDifferent(first.renderPicture(), firstPicture), 0u);
    EXPECT_EQ(readMask(first.pass, 0).size(), 200u * 150u);
    EXPECT_EQ(countDifferent(second.renderPicture(), secondPicture), 0u);
    EXPECT_EQ(readMask(first.pass, 0).size(), 160u * 120u);
  }
}

TEST(PassWindow, RendererMovesToAnotherWindow_ShadowComesWithIt)
{
  BallScene scene;
  const Pixels picture = scene.renderPicture();
  vtkNew<vtkHeadlessRenderWindow> other;
  other->SetSize(200, 150);
  scene.window->RemoveRenderer(scene.renderer);
  other->AddRenderer(scene.renderer);
  other->Render();
  EXPECT_EQ(countDifferent(readPicture(other), picture), 0u);
  other->RemoveRenderer(scene.renderer);
}

TEST(PassWindow, RenderWindowSetToNull_ThenBack_Renders)
{
  BallScene scene;
  const Pixels picture = scene.renderPicture();
  scene.renderer->SetRenderWindow(nullptr);
  scene.renderer->SetRenderWindow(scene.window);
  EXPECT_EQ(countDifferent(scene.renderPicture(), picture), 0u);
}

TEST(PassWindow, ReleaseGraphicsResources_RenderAgain_SamePicture)
{
  BallScene scene;
  const Pixels picture = scene.renderPicture();
  for (int i = 0; i < 3; ++i)
  {
    scene.pass->ReleaseGraphicsResources(scene.window);
    EXPECT_EQ(countDifferent(scene.renderPicture(), picture), 0u);
    scene.renderer->ReleaseGraphicsResources(scene.window);
    EXPECT_EQ(countDifferent(scene.renderPicture(), picture), 0u);
  }
}

TEST(PassWindow, MaskAfterRelease_ErrorNotCrash)
{
  BallScene scene;
  scene.renderMask();
  scene.pass->ReleaseGraphicsResources(scene.window);
  const auto messages = MessageCounter::observe(scene.pass);
  EXPECT_TRUE(readMask(scene.pass, 0).empty());
  EXPECT_EQ(messages->errors, 1);
}

TEST(PassWindow, PassDeletedBeforeWindow_WindowRendersOn)
{
  BallScene scene;
  const Pixels shadowed = scene.renderPicture();
  auto temporary = vtkSmartPointer<vtkShadowVolumePass>::New();
  scene.renderer->SetPass(temporary);
  EXPECT_EQ(countDifferent(scene.renderPicture(), shadowed), 0u);
  scene.renderer->SetPass(nullptr);
  temporary = nullptr;
  EXPECT_GT(countDifferent(scene.renderPicture(), shadowed, 20), 400u);
}

TEST(PassWindow, WindowDeletedBeforePass_PassServesTheNext)
{
  vtkNew<vtkShadowVolumePass> pass;
  for (int i = 0; i < 3; ++i)
  {
    auto scene = std::make_unique<BallScene>();
    scene->renderer->SetPass(pass);
    scene->window->Render();
    EXPECT_GT(countValue(readMask(pass, 0), 0), 400u);
    scene.reset();
    const auto messages = MessageCounter::observe(pass);
    EXPECT_TRUE(readMask(pass, 0).empty());
    EXPECT_EQ(messages->errors, 1);
    pass->RemoveObserver(messages);
    EXPECT_GE(pass->GetMemorySize(), 0);
    pass->GetTotalTriangles();
  }
}

TEST(PassWindow, RendererDeletedBeforePass_StatisticsAnswer)
{
  BallScene scene;
  {
    const vtkSmartPointer<vtkRenderer> second = cloneRenderer(scene);
    second->SetPass(scene.pass);
    scene.window->AddRenderer(second);
    scene.window->Render();
    scene.window->RemoveRenderer(second);
  }
  EXPECT_GE(scene.pass->GetSilhouetteEdges(), 0);
  EXPECT_GE(scene.pass->GetAmbientTriangles(), 0);
  EXPECT_GT(countValue(scene.renderMask(), 0), 400u);
}

TEST(PassRenderers, OneWithBadData_ToldOnce)
{
  BallScene scene;
  const vtkSmartPointer<vtkRenderer> good = cloneRenderer(scene);
  scene.window->AddRenderer(good);
  good->SetPass(scene.pass);
  vtkNew<vtkSphereSource> source;
  source->Update();
  source->GetOutput()->GetPoints()->SetPoint(5, std::nan(""), 0.0, 0.0);
  scene.addPolyData(source->GetOutput());
  const auto messages = MessageCounter::observe(scene.pass);
  for (int frame = 0; frame < 5; ++frame)
  {
    scene.window->Render();
  }
  EXPECT_EQ(messages->warnings, 1) << messages->last;
  EXPECT_EQ(messages->errors, 0) << messages->last;
  EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_OK) << "the good one came last";
}
