#include "OutlineCase.h"

#include <gtest/gtest.h>

#include <vtkCamera.h>

#include "OutlineError.h"

namespace shadow::test
{

using truth::compareOutline;
using truth::OutlineError;
using truth::OutlineOptions;
using truth::OutlineTruth;

void expectRight(truth::OutlineScene& scene, double leastRight)
{
  scene.window->Render();
  OutlineOptions options;
  options.widest = 32.0;
  const OutlineTruth truth = scene.makeOutline(options);
  for (int technique = 0; technique < 2; ++technique)
  {
    scene.outlines->SetTechnique(technique);
    for (const double width : {1.0, 3.0, 32.0})
    {
      const OutlineError error = compareOutline(truth, scene.renderLines(width), width);
      EXPECT_EQ(scene.outlines->GetStatus(), vtkSilhouettePass::STATUS_OK);
      EXPECT_GE(error.completeness(), leastRight) << "technique " << technique << ", width " << width;
      EXPECT_GE(error.correctness(), leastRight) << "technique " << technique << ", width " << width;
      EXPECT_EQ(error.spikes, 0u) << "technique " << technique << ", width " << width;
      EXPECT_GT(error.drawn, 50u) << "technique " << technique << ", width " << width;
    }
  }
}

void setCamera(truth::OutlineScene& scene, const glm::dvec3& position, const glm::dvec3& focus,
               double nearest)
{
  vtkCamera* camera = scene.renderer->GetActiveCamera();
  camera->SetPosition(position.x, position.y, position.z);
  camera->SetFocalPoint(focus.x, focus.y, focus.z);
  camera->SetViewUp(0.0, 1.0, 0.0);
  scene.renderer->ResetCameraClippingRange();
  if (nearest > 0.0)
  {
    camera->SetClippingRange(nearest, 100.0);
  }
}

} // namespace shadow::test
