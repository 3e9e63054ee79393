// Whose mask is kept: several renderers, windows, passes and eyes, and contexts that go.

#include <gtest/gtest.h>

#include <vtkCamera.h>

#include "KeptScene.h"

using namespace shadow::test;
using namespace shadow::truth;

namespace
{

/// Expects that the pass draws what a new one does.
void expectRight(KeptScene& scene)
{
  const DrawnShadows drawn = drawShadows(scene.window, scene.pass);
  EXPECT_EQ(tellDifferences(drawn, drawByNewPass(scene.window, scene.pass)), "");
}

} // namespace

TEST(KeptMask, SavingsOff_NothingIsKept)
{
  KeptScene scene;
  EXPECT_EQ(scene.pass->GetSavings(), vtkShadowVolumePass::SAVINGS_ALL);
  scene.pass->SetSavings(0);
  for (int i = 0; i < 3; ++i)
  {
    scene.window->Render();
    EXPECT_EQ(scene.pass->GetNumberOfKeptLights(), 0);
  }
  scene.pass->SetSavings(vtkShadowVolumePass::SAVINGS_KEPT_MASKS);
  scene.window->Render();
  EXPECT_EQ(scene.pass->GetNumberOfKeptLights(), 0) << "there was nothing to keep";
  scene.window->Render();
  EXPECT_EQ(scene.pass->GetNumberOfKeptLights(), KeptScene::lightCount);
}

TEST(KeptMask, Kept_NoTimeGoesIntoStages)
{
  KeptScene scene;
  scene.window->Render();
  EXPECT_GT(scene.pass->GetPrePassMilliseconds(), 0.0);
  scene.window->Render();
  EXPECT_EQ(scene.pass->GetPrePassMilliseconds(), 0.0);
  EXPECT_EQ(scene.pass->GetSilhouetteMilliseconds(), 0.0);
  EXPECT_EQ(scene.pass->GetStencilMilliseconds(), 0.0);
  EXPECT_GT(scene.pass->GetLightingMilliseconds(), 0.0);
}

TEST(KeptMask, LongStandstill_VolumesAreKeptToo)
{
  KeptScene scene;
  for (int i = 0; i < 4; ++i)
  {
    scene.window->Render();
  }
  scene.renderer->GetActiveCamera()->Azimuth(1.0);
  scene.window->Render();
  EXPECT_EQ(scene.pass->GetNumberOfKeptLights(), 0);
  EXPECT_EQ(scene.pass->GetNumberOfRebuiltVolumes(), 0);
}

TEST(KeptMask, ResourcesReleased_MadeAnew)
{
  KeptScene scene;
  scene.window->Render();
  scene.pass->ReleaseGraphicsResources(scene.window);
  expectRight(scene);
  scene.window->Render();
  scene.window->Finalize();
  scene.window->Render();
  EXPECT_EQ(scene.pass->GetNumberOfKeptLights(), 0);
  expectRight(scene);
}

TEST(KeptMask, PassOffAndOn_OnlyWhatIsStillRight)
{
  KeptScene scene;
  scene.window->Render();
  scene.renderer->SetPass(nullptr);
  scene.window->Render();
  scene.renderer->SetPass(scene.pass);
  scene.window->Render();
  EXPECT_EQ(scene.pass->GetNumberOfKeptLights(), KeptScene::lightCount);
  scene.renderer->SetPass(nullptr);
  scene.ball->SetPosition(0.2, 0.3, 0.1);
  scene.window->Render();
  scene.renderer->SetPass(scene.pass);
  expectRight(scene);
}

TEST(KeptMask, TwoRenderersByOnePass_EachHasItsOwn)
{
  KeptScene scene;
  vtkNew<vtkRenderer> second;
  second->AutomaticLightCreationOff();
  second->AddActor(scene.ball);
  second->AddActor(scene.floor);
  second->AddLight(scene.lights[0]);
  second->GetActiveCamera()->DeepCopy(scene.renderer->GetActiveCamera());
  scene.renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  second->SetViewport(0.5, 0.0, 1.0, 1.0);
  second->SetPass(scene.pass);
  scene.window->AddRenderer(second);
  scene.window->Render();
  scene.window->Render();
  EXPECT_EQ(scene.pass->GetNumberOfKeptLights(), 1) << "of the second one";
  expectRight(scene);
  scene.ball->SetPosition(0.1, 0.2, 0.1);
  expectRight(scene);
  second->RemoveActor(scene.ball);
  expectRight(scene);
  scene.lights[0]->SetPosition(0.0, 5.0, 0.3);
  expectRight(scene);
}

TEST(KeptMask, TwoPassesInTurn_EachHasItsOwn)
{
  KeptScene scene;
  vtkNew<vtkShadowVolumePass> other;
  other->SetCasting(scene.ball, false);
  scene.window->Render();
  for (int i = 0; i < 3; ++i)
  {
    scene.renderer->SetPass(other);
    scene.window->Render();
    EXPECT_EQ(other->GetNumberOfKeptLights(), i == 0 ? 0 : KeptScene::lightCount);
    scene.renderer->SetPass(scene.pass);
    expectRight(scene);
    EXPECT_EQ(scene.pass->GetNumberOfKeptLights(), KeptScene::lightCount);
  }
}

TEST(KeptMask, RendererInAnotherWindow_MadeAnew)
{
  KeptScene scene;
  scene.window->Render();
  vtkNew<vtkHeadlessRenderWindow> other;
  other->SetSize(scene.window->GetSize());
  scene.window->RemoveRenderer(scene.renderer);
  other->AddRenderer(scene.renderer);
  const DrawnShadows drawn = drawShadows(other, scene.pass);
  EXPECT_EQ(scene.pass->GetNumberOfKeptLights(), 0);
  EXPECT_EQ(tellDifferences(drawn, drawByNewPass(other, scene.pass)), "");
  other->RemoveRenderer(scene.renderer);
  scene.window->AddRenderer(scene.renderer);
}

TEST(KeptMask, Stereo_EachEyeHasItsOwn)
{
  KeptScene scene;
  scene.window->Render();
  scene.window->StereoRenderOn();
  scene.window->SetStereoTypeToAnaglyph();
  scene.window->Render(); // of which VTK draws one eye without stereo
  for (int i = 0; i < 2; ++i)
  {
    expectRight(scene);
  }
  scene.window->StereoRenderOff();
  expectRight(scene);
}
