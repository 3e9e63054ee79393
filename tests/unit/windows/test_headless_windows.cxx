// Programs that make their windows themselves, after vtkHeadlessRenderWindow::OverrideRenderWindow(); and where nothing
// can draw. No display is needed, nor asked for.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <dlfcn.h>

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include "BallScene.h"

using namespace shadow::test;

namespace
{

/// As vtkWindowToImageFilter gives it with its own settings.
Pixels takePicture(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->Update();
  auto* values = vtkUnsignedCharArray::SafeDownCast(filter->GetOutput()->GetPointData()->GetScalars());
  return {values->GetPointer(0), values->GetPointer(0) + values->GetNumberOfValues()};
}

using HeadlessOverride = testing::Test;

class HeadlessNowhere : public testing::Test
{
protected:
  void SetUp() override
  {
    for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so", "libEGL.so.1", "libEGL.so"})
    {
      if (dlopen(name, RTLD_NOW | RTLD_LOCAL) != nullptr)
      {
        GTEST_SKIP() << "to be run with files in LD_LIBRARY_PATH that are named like OSMesa and EGL and are none";
      }
    }
  }
};

} // namespace

TEST_F(HeadlessOverride, AnyWindowOfVtk_DrawsThePictureOfTheHeadlessWindow)
{
  vtkHeadlessRenderWindow::OverrideRenderWindow();
  for (const bool withPass : {true, false})
  {
    BallScene scene;
    if (!withPass)
    {
      scene.renderer->SetPass(nullptr);
    }
    const Pixels expected = takePicture(scene.window);
    ASSERT_EQ(countDifferent(scene.renderPicture(), expected, 1), 0u); // but for the filter's own rounding
    scene.window->RemoveRenderer(scene.renderer);
    for (int round = 0; round < 3; ++round)
    {
      vtkNew<vtkRenderWindow> window;
      vtkNew<vtkRenderWindowInteractor> interactor;
      window->SetMultiSamples(0);
      window->SetSize(scene.window->GetSize());
      window->AddRenderer(scene.renderer);
      interactor->SetRenderWindow(window);
      interactor->Initialize();
      EXPECT_EQ(countDifferent(takePicture(window), expected), 0u) << window->GetClassName();
      interactor->TerminateApp();
      // What PyVista does when it is closed.
      window->Finalize();
      EXPECT_EQ(countDifferent(takePicture(window), expected), 0u) << window->GetClassName() << " drawn again";
      window->RemoveRenderer(scene.renderer);
    }
  }
}

TEST_F(HeadlessOverride, Interactor_StartReturns)
{
  vtkHeadlessRenderWindow::OverrideRenderWindow();
  vtkNew<vtkHeadlessRenderWindow> window;
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  if (std::string(interactor->GetClassName()) != "HeadlessInteractor")
  {
    GTEST_SKIP() << "from VTK 9.4 on, on a display, VTK has an interactor of its own";
  }
  interactor->CreateRepeatingTimer(10);
  interactor->Start();
  EXPECT_TRUE(window->IsUsable());
}

TEST_F(HeadlessOverride, BeforeTheFirstPicture_WindowTellsItsGL)
{
  vtkNew<vtkHeadlessRenderWindow> window;
  EXPECT_NE(std::string(window->ReportCapabilities()).find("OpenGL version string"), std::string::npos);
}

TEST_F(HeadlessNowhere, WhateverIsAsked_OneErrorThatSaysWhatIsMissing)
{
  BallScene scene;
  const auto messages = MessageCounter::observe(scene.window);
  scene.window->Start();
  for (const char* missing : {"libosmesa6", "libegl1"})
  {
    EXPECT_NE(messages->last.find(missing), std::string::npos) << messages->last;
  }
  EXPECT_NE(messages->last.find(scene.window->GetStatusMessage()), std::string::npos) << messages->last;
  vtkNew<vtkUnsignedCharArray> colours;
  vtkNew<vtkFloatArray> depths;
  scene.window->Render();
  scene.window->Render();
  EXPECT_EQ(std::string(scene.window->ReportCapabilities()), "no OpenGL\n");
  scene.window->GetPixelData(0, 0, 9, 9, 1, colours, 0);
  scene.window->GetZbufferData(0, 0, 9, 9, depths);
  scene.window->CopyResultFrame();
  scene.window->Finalize();
  takePicture(scene.window);
  EXPECT_FALSE(scene.window->IsUsable());
  EXPECT_EQ(messages->errors, 1);
}
