// What VTKSHADOW_HEADLESS chooses. It holds for a whole process, so that each suite has to be run with a
// value of its own, as ctest does.

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include <dlfcn.h>

#include "BallScene.h"
#include "EveryMethod.h"

using namespace shadow::test;

namespace
{

class Headless : public testing::Test
{
protected:
  static std::string chosen()
  {
    const char* value = std::getenv("VTKSHADOW_HEADLESS");
    return value != nullptr ? value : "";
  }
};

class HeadlessEGL : public Headless
{
protected:
  void SetUp() override
  {
    if (this->chosen() != "egl")
    {
      GTEST_SKIP() << "to be run with VTKSHADOW_HEADLESS=egl";
    }
    if (dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL) == nullptr)
    {
      GTEST_SKIP() << "there is no libEGL to test: " << dlerror();
    }
  }
};

using HeadlessOSMesa = Headless;
using HeadlessUnknown = Headless;

} // namespace

TEST_F(HeadlessEGL, EveryMethod_MaskIsTheTruth)
{
  BallScene scene;
  scene.addDirectionalLight(0.5, -1.0, 0.2);
  scene.window->Render();
  ASSERT_EQ(scene.window->GetBackend().substr(0, 4), "EGL ");
  for (int light = 0; light < 2; ++light)
  {
    const shadow::truth::SceneTruth truth = scene.makeTruth(light);
    for (const shadow::truth::ShadowMethod& method : shadow::truth::everyMethod(scene.pass))
    {
      method.use(scene.pass);
      EXPECT_LE(scene.compare(truth, light).wrongCertain, rimPixels) << method.getName();
      EXPECT_EQ(scene.pass->GetStatusMessage(), "") << method.getName();
    }
  }
}

TEST_F(HeadlessEGL, TwoWindowsInTurns_EachKeepsItsPicture)
{
  BallScene first;
  BallScene second(160, 160);
  second.lamp->SetPosition(-3.0, 4.0, 1.0);
  const Pixels firstMask = first.renderMask();
  const Pixels secondMask = second.renderMask();
  EXPECT_EQ(countDifferent(first.renderMask(), firstMask), 0u);
  EXPECT_EQ(countDifferent(second.renderMask(), secondMask), 0u);
  {
    BallScene third;
    EXPECT_EQ(countDifferent(third.renderMask(), firstMask), 0u);
  }
  EXPECT_EQ(countDifferent(first.renderMask(), firstMask), 0u);
}

TEST_F(HeadlessOSMesa, NothingChosen_DrawsByOSMesaOrElseByEGL)
{
  if (!this->chosen().empty())
  {
    GTEST_SKIP() << "to be run without VTKSHADOW_HEADLESS";
  }
  BallScene scene;
  EXPECT_LE(scene.compare().wrongCertain, rimPixels);
  const bool hasOSMesa = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL) != nullptr ||
                         dlopen("libOSMesa.so.6", RTLD_NOW | RTLD_LOCAL) != nullptr;
  EXPECT_EQ(scene.window->GetBackend().substr(0, 3), hasOSMesa ? "OSM" : "EGL");
}

TEST_F(HeadlessUnknown, OneErrorThatNamesTheChoices)
{
  if (this->chosen() != "display")
  {
    GTEST_SKIP() << "to be run with VTKSHADOW_HEADLESS=display";
  }
  vtkNew<vtkHeadlessRenderWindow> window;
  const auto messages = MessageCounter::observe(window);
  EXPECT_FALSE(window->IsUsable());
  EXPECT_EQ(window->GetBackend(), "");
  window->Render();
  window->Render();
  EXPECT_EQ(messages->errors, 1);
  EXPECT_NE(messages->last.find("display, and not osmesa or egl"), std::string::npos) << messages->last;
}
