// Outlines leave picking and the GL as they found them.

#include <string>

#include <gtest/gtest.h>

#include <vtkHardwareSelector.h>
#include <vtkProperty.h>
#include <vtkSelection.h>

#include "GLInspection.h"
#include "OpenGL.h"
#include "OutlineBall.h"

using namespace shadow::test;

TEST(OutlinePass, HardwareSelector_SameHitsWithAndWithoutPass)
{
  const auto pick = [](BallScene& scene)
  {
    scene.window->Render();
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(scene.renderer);
    selector->SetArea(0, 0, 199, 149);
    const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
    return selection != nullptr ? selection->GetNumberOfNodes() : 0u;
  };
  OutlineBall scene;
  scene.outlines->SetLineWidth(16.0);
  const unsigned int with = pick(scene);
  const Pixels before = scene.renderLines();
  scene.renderer->SetPass(nullptr);
  EXPECT_EQ(pick(scene), with);
  EXPECT_EQ(with, 2u);
  scene.renderer->SetPass(scene.outlines);
  EXPECT_EQ(scene.renderLines(), before);
}

TEST(OutlinePass, GLState_AsFoundAfterEveryRendering)
{
  for (const int technique : {vtkSilhouettePass::TECHNIQUE_RECTANGLES, vtkSilhouettePass::TECHNIQUE_FACES})
  {
    OutlineBall scene;
    scene.outlines->LinesOnlyOn();
    scene.outlines->SetTechnique(technique);
    expectGLStateKept(scene.renderer, scene.outlines, "technique " + std::to_string(technique));
    // With the window's depth looked up and written to.
    scene.addMapper(scene.ballActor->GetMapper())->GetProperty()->SetRepresentationToWireframe();
    scene.addMapper(scene.ballActor->GetMapper())->GetProperty()->SetOpacity(0.5);
    expectGLStateKept(scene.renderer, scene.outlines, "more drawn, technique " + std::to_string(technique));
  }
}

TEST(OutlinePass, SwitchedOnAndOff_LeaksNothing)
{
  OutlineBall scene;
  scene.outlines->SetTechniqueToFaces();
  scene.renderLines();
  scene.outlines->SetTechniqueToRectangles();
  scene.renderLines();
  scene.renderer->SetPass(nullptr);
  scene.outlines->ReleaseGraphicsResources(scene.window);
  scene.window->Render();
  const auto first = countGLObjects(scene.window);
  for (int i = 0; i < 5; ++i)
  {
    scene.renderer->SetPass(scene.outlines);
    scene.outlines->SetLineWidth(1.0 + i);
    scene.outlines->SetTechnique(i % 2);
    EXPECT_GT(countValue(scene.renderLines(), 255), 200u);
    EXPECT_GT(scene.outlines->GetMemorySize(), 100000);
    scene.renderer->SetPass(nullptr);
    scene.outlines->ReleaseGraphicsResources(scene.window);
    scene.window->Render();
    EXPECT_EQ(countGLObjects(scene.window), first) << i;
  }
}
