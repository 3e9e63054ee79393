// Outlines on a GL that refuses what they need: told once, and the scene is drawn without.

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>

#include "OutlineBall.h"
#include "RefusingGL.h"

using namespace shadow::test;

namespace
{

bool says(vtkSilhouettePass* pass, const std::string& text)
{
  return pass->GetStatusMessage().find(text) != std::string::npos;
}

/// A triangle that cannot be used, as one of its points is not finite.
vtkSmartPointer<vtkPolyData> makeBroken()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.0);
  points->InsertNextPoint(0.0, std::numeric_limits<double>::infinity(), 0.0);
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({0, 1, 2});
  auto broken = vtkSmartPointer<vtkPolyData>::New();
  broken->SetPoints(points);
  broken->SetPolys(triangles);
  return broken;
}

/// VTK's picture alone: the GL's functions are loaded then, and VTK has its own shaders.
void renderPlain(OutlineBall& scene)
{
  scene.renderer->SetPass(nullptr);
  scene.window->Render();
  scene.renderer->SetPass(scene.outlines);
}

} // namespace

TEST(OutlineRefusal, MoreLinesThanTheGLLooksUp_MeshWithoutOutline)
{
  OutlineBall scene;
  const auto messages = MessageCounter::observe(scene.outlines);
  Pixels lines;
  renderPlain(scene);
  {
    // Enough for the table.
    const TexelLimit limit(12);
    lines = scene.renderLines();
    EXPECT_EQ(scene.outlines->GetStatus(), vtkSilhouettePass::STATUS_PARTIAL);
    EXPECT_TRUE(says(scene.outlines, "has no outline: it has more lines than the GL can look up"));
    scene.renderLines();
    EXPECT_EQ(messages->warnings, 1);
  }
  // The lines are found anew for another eye.
  scene.renderer->GetActiveCamera()->Azimuth(1e-6);
  EXPECT_GT(countValue(scene.renderLines(), 255), countValue(lines, 255) + 100);
  EXPECT_EQ(scene.outlines->GetStatus(), vtkSilhouettePass::STATUS_OK) << scene.outlines->GetStatusMessage();
}

TEST(OutlineRefusal, MeshLargerThanTheGLLooksUp_MeshWithoutOutline)
{
  for (int technique = 0; technique < 2; ++technique)
  {
    OutlineBall scene;
    scene.outlines->SetTechnique(technique);
    scene.ball->SetThetaResolution(48);
    scene.ball->SetPhiResolution(37);
    const auto messages = MessageCounter::observe(scene.outlines);
    const Pixels all = scene.renderLines();
    {
      // The table's and the lines of both, but not the ball's vertices.
      const TexelLimit limit(1000);
      const Pixels lines = scene.renderLines();
      EXPECT_EQ(scene.outlines->GetStatus(), vtkSilhouettePass::STATUS_PARTIAL);
      EXPECT_TRUE(says(scene.outlines, "has no outline: the GL cannot look up a mesh of its size"));
      EXPECT_GT(countValue(lines, 255), 0u) << "the table has its lines";
      EXPECT_LT(countValue(lines, 255), countValue(all, 255));
      scene.renderLines();
      EXPECT_EQ(messages->warnings, 1);
    }
    EXPECT_EQ(scene.renderLines(), all);
    EXPECT_EQ(scene.outlines->GetStatus(), vtkSilhouettePass::STATUS_OK);
  }
}

TEST(OutlineRefusal, NoTarget_SceneWithoutLines_BadMeshesAreToldAllTheSame)
{
  OutlineBall scene;
  scene.outlines->SetDelegatePass(scene.pass);
  scene.addPolyData(makeBroken());
  const auto messages = MessageCounter::observe(scene.outlines);
  scene.outlines->SetLineWidth(2.0);
  const Pixels all = scene.renderLines();
  EXPECT_EQ(messages->warnings, 1);
  {
    const FramebufferRefusal refusal;
    // Another width takes another target.
    scene.outlines->SetLineWidth(9.0);
    scene.window->Render();
    EXPECT_EQ(scene.outlines->GetStatus(), vtkSilhouettePass::STATUS_NOT_SUPPORTED);
    EXPECT_EQ(scene.outlines->GetStatusMessage().find("the GL refuses an outline target of "), 0u);
    EXPECT_TRUE(says(scene.outlines, "has no outline"));
    scene.window->Render();
    EXPECT_EQ(messages->warnings, 2);
    EXPECT_EQ(messages->errors, 0);
    EXPECT_TRUE(readLines(scene.outlines).empty());
    EXPECT_EQ(scene.pass->GetNumberOfShadowLights(), 1) << "the delegate draws what it would";
  }
  scene.outlines->SetLineWidth(2.0);
  EXPECT_EQ(scene.renderLines(), all);
  EXPECT_EQ(scene.outlines->GetStatus(), vtkSilhouettePass::STATUS_PARTIAL);
}

TEST(OutlineRefusal, StageThatFailsAfterAMesh_BothAreTold)
{
  OutlineBall scene;
  const auto messages = MessageCounter::observe(scene.outlines);
  renderPlain(scene);
  const int verbosity = vtkObject::GetGlobalWarningDisplay();
  vtkObject::GlobalWarningDisplayOff();
  {
    const TexelLimit limit(12);
    const ShaderRefusal refusal;
    scene.window->Render();
  }
  vtkObject::SetGlobalWarningDisplay(verbosity);
  EXPECT_EQ(scene.outlines->GetStatus(), vtkSilhouettePass::STATUS_NOT_SUPPORTED);
  EXPECT_TRUE(says(scene.outlines, "a shader of the outlines does not compile"));
  EXPECT_TRUE(says(scene.outlines, "more lines than the GL can look up"));
}

TEST(OutlineRefusal, MeshLargerThanTheGLLooksUp_ItsNormalsAreNotUploaded)
{
  OutlineBall scene;
  scene.outlines->SetTechniqueToFaces();
  scene.ball->SetThetaResolution(48);
  scene.ball->SetPhiResolution(37);
  vtkIdType refused = 0;
  renderPlain(scene);
  {
    const TexelLimit limit(1000);
    scene.renderLines();
    refused = scene.outlines->GetMemorySize();
  }
  scene.renderLines();
  EXPECT_GE(scene.outlines->GetMemorySize(), refused + 12 * 2 * 48 * 35);
}
