// Every kind of light.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include <vtkCamera.h>
#include <vtkLightCollection.h>
#include <vtkProperty.h>

#include "BallScene.h"

using namespace shadow::test;

namespace
{

/// Makes all light diffuse, so that grey levels can be told in advance: ambient 0.2, diffuse 0.8.
void makeMatt(BallScene& scene)
{
  scene.table->GetProperty()->SetAmbient(0.2);
  scene.table->GetProperty()->SetDiffuse(0.8);
  scene.table->GetProperty()->SetSpecular(0.0);
}

double cosineAt(const glm::dvec3& pointWC, const glm::dvec3& lightWC)
{
  return glm::normalize(lightWC - pointWC).y;
}

} // namespace

TEST(PassLight, SpotOfAnyCone_MaskIsTheTruth)
{
  for (const double cone : {5.0, 40.0, 89.0, 90.0, 91.0, 120.0, 179.0, 180.0})
  {
    BallScene scene;
    scene.lamp->SetConeAngle(cone);
    scene.lamp->SetFocalPoint(0.0, 1.0, 0.0);
    EXPECT_LE(scene.compare().wrongCertain, rimPixels) << cone;
    EXPECT_EQ(scene.maskAt(BallScene::inShadow), 0) << cone;
    EXPECT_EQ(scene.maskAt(BallScene::lit), 255) << cone;
  }
}

TEST(PassLight, SpotOf90AndMore_ShadowsInThePicture)
{
  for (const double cone : {40.0, 90.0, 150.0})
  {
    BallScene scene;
    scene.lamp->SetConeAngle(cone);
    scene.lamp->SetFocalPoint(0.0, 1.0, 0.0);
    const double shadowed = scene.greyAt(BallScene::inShadow);
    scene.pass->SetCasting(scene.ballActor, false);
    EXPECT_GT(scene.greyAt(BallScene::inShadow), shadowed + 40.0) << cone;
  }
}

TEST(PassLight, Directional_MaskIsTheTruth)
{
  BallScene scene;
  scene.renderer->RemoveLight(scene.lamp);
  scene.addDirectionalLight(0.5, -1.0, 0.0);
  EXPECT_LE(scene.compare().wrongCertain, rimPixels);
  EXPECT_EQ(scene.maskAt(BallScene::inShadow), 0);
  EXPECT_EQ(scene.maskAt(BallScene::lit), 255);
}

TEST(PassLight, ThirtyTwoAtOnce_EachHasItsMask)
{
  BallScene scene;
  scene.renderer->RemoveAllLights();
  for (int i = 0; i < 32; ++i)
  {
    const double angle = 2.0 * 3.14159265 * i / 32.0;
    vtkLight* light = scene.addPointLight(2.0 * std::cos(angle), 4.0, 2.0 * std::sin(angle));
    light->SetIntensity(1.0 / 32.0);
  }
  const auto messages = MessageCounter::observe(scene.pass);
  scene.window->Render();
  EXPECT_EQ(scene.pass->GetNumberOfShadowLights(), 32);
  EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_OK) << scene.pass->GetStatusMessage();
  EXPECT_EQ(messages->errors + messages->warnings, 0);
  for (const int light : {0, 1, 15, 16, 30, 31})
  {
    EXPECT_LE(scene.compare(light).wrongCertain, rimPixels) << light;
  }
}

TEST(PassLight, ThirtyThird_ReportedOnceAndDrawnWithoutShadow)
{
  BallScene scene;
  scene.renderer->RemoveAllLights();
  for (int i = 0; i < 33; ++i)
  {
    scene.addPointLight(-1.5 + 0.01 * i, 4.0, 0.0)->SetIntensity(1.0 / 33.0);
  }
  const auto messages = MessageCounter::observe(scene.pass);
  const double shadowed = scene.greyAt(BallScene::inShadow);
  EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_PARTIAL);
  EXPECT_NE(scene.pass->GetStatusMessage().find("light 32"), std::string::npos)
      << scene.pass->GetStatusMessage();
  EXPECT_EQ(messages->warnings, 1);
  scene.window->Render();
  EXPECT_EQ(messages->warnings, 1) << "the same cause is told once";
  EXPECT_EQ(messages->errors, 0);
  EXPECT_EQ(countValue(scene.renderMask(32), 255), 200u * 150u);

  // The last light alone is what is left in the shadow, above the ambient light.
  auto* last = vtkLight::SafeDownCast(scene.renderer->GetLights()->GetItemAsObject(32));
  const double share = last->GetIntensity() * 0.85 * 255.0 * cosineAt(BallScene::inShadow, {-1.18, 4.0, 0.0});
  last->SetIntensity(0.0);
  EXPECT_NEAR(shadowed - scene.greyAt(BallScene::inShadow), share, 1.5);

  for (const int compositing :
       {vtkShadowVolumePass::COMPOSITING_MASK, vtkShadowVolumePass::COMPOSITING_ADDITIVE})
  {
    last->SetIntensity(1.0 / 33.0);
    scene.pass->SetCompositing(compositing);
    EXPECT_NEAR(scene.greyAt(BallScene::inShadow), shadowed, 1.5);
  }
}

TEST(PassLight, SwitchedOff_Skipped)
{
  BallScene scene;
  vtkLight* off = scene.addPointLight(1.5, 4.0, 0.0);
  const Pixels first = scene.renderMask(0);
  const Pixels second = scene.renderMask(1);
  EXPECT_NE(first, second);
  EXPECT_EQ(scene.pass->GetNumberOfShadowLights(), 2);
  off->SwitchOff();
  EXPECT_EQ(scene.renderMask(0), first);
  EXPECT_EQ(scene.pass->GetNumberOfShadowLights(), 1);
  off->SwitchOn();
  scene.lamp->SwitchOff();
  EXPECT_EQ(scene.renderMask(0), second) << "lights are counted among those that are switched on";
  scene.lamp->SwitchOn();
  EXPECT_EQ(scene.renderMask(0), first);
}

TEST(PassLight, Headlight_CastsNothing)
{
  BallScene scene;
  attachPlainSteps(scene.renderer);
  scene.lamp->SetLightTypeToHeadlight();
  scene.lamp->SetPositional(false);
  const Pixels plain = scene.renderPicture();
  scene.renderer->SetPass(scene.pass);
  EXPECT_EQ(countDifferent(scene.renderPicture(), plain, 1), 0u);
  EXPECT_EQ(countValue(scene.renderMask(), 255), 200u * 150u);
  EXPECT_EQ(scene.pass->GetNumberOfShadowLights(), 0);
  EXPECT_EQ(scene.pass->GetNumberOfCasters(), 0);
}

TEST(PassLight, AutomaticHeadlight_CastsNothing)
{
  BallScene scene;
  scene.renderer->RemoveAllLights();
  scene.renderer->AutomaticLightCreationOn();
  EXPECT_EQ(countValue(scene.renderMask(), 255), 200u * 150u);
}

TEST(PassLight, CameraLight_MovesWithTheCamera)
{
  BallScene scene;
  scene.renderer->RemoveAllLights();
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(-0.6, 0.8, 1.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  scene.renderer->AddLight(light);
  EXPECT_LE(scene.compare().wrongCertain, rimPixels);
  const Pixels before = scene.renderMask();
  EXPECT_GT(countValue(before, 0), 100u);
  scene.renderer->GetActiveCamera()->Azimuth(40.0);
  EXPECT_LE(scene.compare().wrongCertain, rimPixels);
  EXPECT_NE(scene.renderMask(), before);
}

TEST(PassLight, ShadowIntensityAndAttenuation_TakeTheirShare)
{
  BallScene scene;
  makeMatt(scene);
  const double cosine = cosineAt(BallScene::inShadow, {-1.5, 4.0, 0.0});
  for (const int compositing :
       {vtkShadowVolumePass::COMPOSITING_MASK, vtkShadowVolumePass::COMPOSITING_ADDITIVE})
  {
    scene.pass->SetCompositing(compositing);
    for (const double intensity : {0.0, 0.25, 1.0})
    {
      for (const double attenuation : {0.0, 0.5, 1.0})
      {
        scene.pass->SetShadowIntensity(intensity);
        scene.lamp->SetShadowAttenuation(static_cast<float>(attenuation));
        const double expected = 255.0 * (0.2 + 0.8 * cosine * (1.0 - intensity * attenuation));
        EXPECT_NEAR(scene.greyAt(BallScene::inShadow), expected, 2.0) << intensity << ", " << attenuation;
        EXPECT_EQ(scene.maskAt(BallScene::inShadow), 0) << "the mask tells where, not how dark";
      }
    }
  }
}

TEST(PassLight, LightInsideTheBall_OnlyTheBallsInsideIsReached)
{
  BallScene scene;
  scene.lamp->SetPosition(0.0, 1.0, 0.0);
  EXPECT_LE(scene.compare().wrongCertain, rimPixels);
  EXPECT_EQ(scene.maskAt(BallScene::lit), 0);
}

TEST(PassLight, DirectionlessLight_ReportedAndNoCrash)
{
  BallScene scene;
  scene.lamp->SetPositional(false);
  scene.lamp->SetFocalPoint(scene.lamp->GetPosition());
  const auto messages = MessageCounter::observe(scene.pass);
  scene.window->Render();
  EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_PARTIAL);
  EXPECT_EQ(messages->warnings, 1);
}
