// Lines are of what VTK draws; settings and delegates that make no sense are told of.

#include <algorithm>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include <vtkCameraPass.h>
#include <vtkImageData.h>
#include <vtkShaderProperty.h>
#include <vtkSkybox.h>
#include <vtkTexture.h>

#include "ExcludingCuller.h"
#include "OutlineBall.h"

using namespace shadow::test;

TEST(OutlineDrawn, Skybox_HasNoLines)
{
  OutlineBall scene;
  const Pixels without = scene.renderLines();
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 24, static_cast<unsigned char>(90));
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  vtkNew<vtkSkybox> sky;
  sky->SetTexture(texture);
  sky->SetProjectionToSphere();
  scene.renderer->AddActor(sky);
  EXPECT_GT(without.size() - countValue(without, 0), fewestLinePixels);
  EXPECT_EQ(countDifferent(scene.renderLines(), without), 0u);
}

TEST(OutlineDrawn, ShaderThatMovesVertices_NoLinesAtTheOldPlace)
{
  OutlineBall scene;
  scene.ballActor->VisibilityOff();
  const Pixels tableOnly = scene.renderLines();
  scene.ballActor->VisibilityOn();
  scene.ballActor->GetShaderProperty()->AddVertexShaderReplacement(
      "//VTK::PositionVC::Impl", true,
      "//VTK::PositionVC::Impl\ngl_Position = MCDCMatrix * (vertexMC + vec4(0.0, 0.5, 0.0, 0.0));\n", false);
  EXPECT_EQ(countDifferent(scene.renderLines(), tableOnly), 0u);
}

TEST(OutlineDrawn, PropThatVtkCulls_HasNoLinesAndHidesNone)
{
  for (const int technique : {vtkSilhouettePass::TECHNIQUE_RECTANGLES, vtkSilhouettePass::TECHNIQUE_FACES})
  {
    OutlineBall scene;
    scene.outlines->SetTechnique(technique);
    const Pixels both = scene.renderLines();
    scene.ballActor->VisibilityOff();
    const Pixels tableOnly = scene.renderLines();
    EXPECT_GT(countDifferent(both, tableOnly), 100u);
    scene.ballActor->VisibilityOn();
    vtkNew<ExcludingCuller> culler;
    culler->excluded = scene.ballActor;
    scene.renderer->AddCuller(culler);
    EXPECT_EQ(countDifferent(scene.renderLines(), tableOnly), 0u);
    culler->excluded = nullptr;
    EXPECT_EQ(countDifferent(scene.renderLines(), both), 0u);
  }
}

TEST(OutlineDrawn, LineWidthThatIsNone_OneWarningAndTheOldWidth)
{
  OutlineBall scene;
  const auto messages = MessageCounter::observe(scene.outlines);
  const double infinity = std::numeric_limits<double>::infinity();
  int refused = 0;
  for (const double width : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity, -3.0, 0.0})
  {
    scene.outlines->SetLineWidth(width);
    EXPECT_EQ(messages->warnings, ++refused) << width;
    EXPECT_EQ(scene.outlines->GetLineWidth(), 2.0) << width;
  }
  scene.outlines->SetLineWidth(1000.0);
  EXPECT_EQ(scene.outlines->GetLineWidth(), 64.0);
  EXPECT_EQ(messages->warnings, refused);
}

TEST(OutlineDrawn, DelegatesInACircle_StatusSaysSo)
{
  OutlineBall scene;
  vtkNew<vtkSilhouettePass> other;
  vtkNew<vtkCameraPass> camera;
  scene.outlines->SetDelegatePass(camera);
  camera->SetDelegatePass(other);
  other->SetDelegatePass(scene.outlines);
  const auto messages = MessageCounter::observe(scene.outlines);
  scene.window->Render();
  EXPECT_EQ(scene.outlines->GetStatus(), vtkSilhouettePass::STATUS_NOT_SUPPORTED);
  EXPECT_NE(std::string(scene.outlines->GetStatusMessage()).find("lead back"), std::string::npos);
  EXPECT_EQ(messages->warnings + messages->errors, 1);
  scene.outlines->ReleaseGraphicsResources(scene.window);
  other->SetDelegatePass(nullptr);
  scene.window->Render();
  EXPECT_EQ(scene.outlines->GetStatus(), vtkSilhouettePass::STATUS_OK) << scene.outlines->GetStatusMessage();
}

TEST(OutlineDrawn, ViewportWithoutHeight_NothingAndNoError)
{
  OutlineBall scene;
  scene.renderer->SetViewport(0.0, 0.5, 1.0, 0.5);
  const auto messages = MessageCounter::observe(scene.outlines);
  scene.window->Render();
  EXPECT_EQ(scene.outlines->GetStatus(), vtkSilhouettePass::STATUS_OK) << scene.outlines->GetStatusMessage();
  EXPECT_EQ(messages->warnings + messages->errors, 0) << messages->last;
}
