// Lines of meshes with faces that have no area, by both techniques.

#include <gtest/gtest.h>

#include <vtkCamera.h>

#include "BallScene.h"
#include "FacesWithoutArea.h"
#include "OutlineCase.h"

using namespace shadow::test;
using shadow::truth::OutlineScene;

TEST(OutlineWithoutArea, Flat_NoLineButBorders)
{
  for (const auto& [name, soup] : makeFlatWithoutArea())
  {
    SCOPED_TRACE(name);
    OutlineScene scene(200, 150);
    scene.addPolyData(toPolyData(soup));
    for (int technique = 0; technique < 2; ++technique)
    {
      scene.outlines->SetTechnique(technique);
      for (const double x : {-4.0, 4.0})
      {
        setCamera(scene, {x, 0.3, 0.4}, {0.0, 0.0, 0.0});
        scene.outlines->BorderEdgesOff();
        scene.outlines->CreaseEdgesOff();
        EXPECT_EQ(countValue(scene.renderLines(2.0), 255), 0u) << "technique " << technique << ", x " << x;
        scene.outlines->CreaseEdgesOn();
        scene.outlines->SetFeatureAngle(0.0);
        EXPECT_EQ(countValue(scene.renderLines(2.0), 255), 0u)
            << "creases, technique " << technique << ", x " << x;
        scene.outlines->CreaseEdgesOff();
        scene.outlines->BorderEdgesOn();
        EXPECT_GT(countValue(scene.renderLines(2.0), 255), 200u);
        EXPECT_EQ(scene.outlines->GetStatus(), vtkSilhouettePass::STATUS_OK);
      }
    }
    setCamera(scene, {4.0, 0.3, 0.4}, {0.0, 0.0, 0.0});
    expectRight(scene);
  }
}
