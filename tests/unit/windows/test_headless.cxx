// What VTKSHADOW_HEADLESS chooses. It holds for a whole process, so that each suite has to be run with a
// value of its own, as ctest does.

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include <dlfcn.h>

#include "../../../plugin/vtkShadowCompat.h"
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

using HeadlessUnset = Headless;
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

TEST_F(HeadlessUnset, DrawsByWhatThereIs)
{
  if (!this->chosen().empty())
  {
    GTEST_SKIP() << "to be run without VTKSHADOW_HEADLESS";
  }
  BallScene scene;
  EXPECT_LE(scene.compare().wrongCertain, rimPixels);
  const auto has = [](const char* name) { return dlopen(name, RTLD_NOW | RTLD_LOCAL) != nullptr; };
  const bool hasOSMesa = has("libOSMesa.so.8") || has("libOSMesa.so.6");
  // As VTK's own windows, where these need no display.
  const bool byEGL = !hasOSMesa || (VTKSHADOW_VTK_DRAWS_HEADLESS && has("libEGL.so.1"));
  EXPECT_EQ(scene.window->GetBackend().substr(0, 3), byEGL ? "EGL" : "OSM");
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
