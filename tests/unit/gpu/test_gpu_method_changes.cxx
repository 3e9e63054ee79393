// What changes in a scene from frame to frame, with every silhouette method. ctest runs this on GL 3.2
// and 3.3 as well.

#include <gtest/gtest.h>

#include <vtkActor.h>

#include "BallScene.h"
#include "SilhouetteMethods.h"

using namespace shadow;
using namespace shadow::test;

TEST(GPUMethods, WhatMoves_EveryMethodFollows)
{
  for (const int method : allMethods(BallScene().pass))
  {
    SCOPED_TRACE(nameOf(method));
    BallScene scene;
    BallScene fresh;
    scene.pass->SetSilhouetteMethod(method);
    const auto expectSame = [&]
    {
      EXPECT_LE(countDifferent(scene.renderMask(), fresh.renderMask()), 2u);
      EXPECT_LE(countDifferent(scene.renderMask(), fresh.renderMask()), 2u) << "again";
    };
    expectSame();
    for (BallScene* each : {&scene, &fresh})
    {
      each->lamp->SetPosition(1.0, 3.0, 0.5);
    }
    expectSame();
    for (BallScene* each : {&scene, &fresh})
    {
      each->ballActor->SetPosition(-0.3, 0.2, 0.4);
    }
    expectSame();
    for (BallScene* each : {&scene, &fresh})
    {
      each->ball->SetThetaResolution(9);
    }
    expectSame();
    for (BallScene* each : {&scene, &fresh})
    {
      each->addPointLight(-2.0, 3.0, 1.0);
    }
    expectSame();
    scene.pass->ReleaseGraphicsResources(scene.window);
    expectSame();
    for (BallScene* each : {&scene, &fresh})
    {
      each->renderer->RemoveActor(each->ballActor);
    }
    expectSame();
  }
}

// What is kept of a path goes with the path, though the triangles and lights look the same as before.
TEST(GPUMethods, LightOrActorGoneForAFrame_EveryMethodStartsAnew)
{
  for (const int method : allMethods(BallScene().pass))
  {
    SCOPED_TRACE(nameOf(method));
    BallScene scene;
    scene.pass->SetSilhouetteMethod(method);
    const Pixels expected = scene.renderMask();
    scene.lamp->SwitchOff();
    scene.window->Render();
    scene.lamp->SwitchOn();
    EXPECT_EQ(scene.renderMask(), expected);

    vtkActor* twin = scene.addMapper(scene.ballActor->GetMapper());
    scene.ballActor->VisibilityOff();
    twin->SetUserMatrix(scene.ballActor->GetMatrix());
    EXPECT_EQ(scene.renderMask(), expected);
  }
}
