// Shadows follow whatever changes, and nothing is built anew that has not changed.

#include <gtest/gtest.h>

#include <vtkAssembly.h>
#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include "BallScene.h"

using namespace shadow::test;

namespace
{

vtkSmartPointer<vtkActor> makeBall(double x, double y, double z)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(x, y, z);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

/// Renders once without change: everything has to be there.
void expectNothingRebuilt(BallScene& scene)
{
  scene.window->Render();
  EXPECT_EQ(scene.pass->GetNumberOfRebuiltVolumes(), 0);
}

} // namespace

TEST(PassChange, Nothing_NothingRebuilt)
{
  BallScene scene;
  scene.window->Render();
  EXPECT_EQ(scene.pass->GetNumberOfRebuiltVolumes(), 1);
  expectNothingRebuilt(scene);
  scene.renderer->GetActiveCamera()->Azimuth(2.0);
  expectNothingRebuilt(scene);
}

TEST(PassChange, SilhouetteMethod_RebuiltWithTheSamePicture)
{
  BallScene scene;
  const Pixels expected = scene.renderMask();
  for (int method = scene.pass->GetSilhouetteMethodMinValue();
       method <= scene.pass->GetSilhouetteMethodMaxValue(); ++method)
  {
    if (method == scene.pass->GetSilhouetteMethod())
    {
      continue;
    }
    scene.pass->SetSilhouetteMethod(method);
    EXPECT_EQ(scene.renderMask(), expected) << "method " << method;
    // Volumes that are drawn from what the GPU found are kept by nobody.
    const bool resident = method > vtkShadowVolumePass::SILHOUETTE_FACING_TEXTURE;
    EXPECT_EQ(scene.pass->GetNumberOfRebuiltVolumes(), resident ? 0 : 1) << "method " << method;
    EXPECT_GT(scene.pass->GetSideTriangles(), 0) << "method " << method;
    expectNothingRebuilt(scene);
  }
}

TEST(PassChange, CoplanarTolerance_IsSeenByHybridAlone)
{
  BallScene scene;
  const Pixels expected = scene.renderMask();
  scene.pass->SetCoplanarTolerance(40.0);
  EXPECT_EQ(scene.renderMask(), expected) << "brute force has no tolerance";
  scene.pass->SetSilhouetteMethodToHybrid();
  EXPECT_NE(scene.renderMask(), expected);
  EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_OK);
  scene.pass->SetCoplanarTolerance(0.0);
  EXPECT_EQ(scene.renderMask(), expected);
}

TEST(PassChange, SourceParameterOnly_ShadowFollows)
{
  BallScene scene;
  const Pixels before = scene.renderMask();
  scene.ball->SetRadius(0.8);
  BallScene fresh;
  fresh.ball->SetRadius(0.8);
  const Pixels after = scene.renderMask();
  EXPECT_NE(after, before);
  EXPECT_EQ(after, fresh.renderMask());
  EXPECT_EQ(countDifferent(scene.renderPicture(), fresh.renderPicture()), 0u);
  expectNothingRebuilt(scene);
}

TEST(PassChange, PointsMovedInPlace_ShadowFollows)
{
  for (const bool modifyPoints : {true, false})
  {
    BallScene scene;
    scene.ball->Update();
    vtkNew<vtkPolyData> polyData;
    polyData->DeepCopy(scene.ball->GetOutput());
    auto* mapper = vtkPolyDataMapper::SafeDownCast(scene.ballActor->GetMapper());
    mapper->SetInputData(polyData);
    const Pixels before = scene.renderMask();
    vtkPoints* points = polyData->GetPoints();
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      double point[3];
      points->GetPoint(i, point);
      points->SetPoint(i, point[0] - 0.3, point[1] + 0.2, point[2] + 0.4);
    }
    modifyPoints ? points->Modified() : polyData->Modified();
    EXPECT_NE(scene.renderMask(), before);
    EXPECT_LE(scene.compare().wrongCertain, rimPixels);
    expectNothingRebuilt(scene);
  }
}

TEST(PassChange, InputConnectionOnly_ShadowFollows)
{
  BallScene scene;
  const Pixels before = scene.renderMask();
  vtkNew<vtkCubeSource> cube;
  cube->SetCenter(0.0, 1.0, 0.0);
  scene.ballActor->GetMapper()->SetInputConnection(cube->GetOutputPort());
  EXPECT_NE(scene.renderMask(), before);
  EXPECT_EQ(scene.compare().wrongCertain, 0u);
  scene.ballActor->GetMapper()->SetInputConnection(scene.ball->GetOutputPort());
  EXPECT_EQ(scene.renderMask(), before);
}

TEST(PassChange, MapperReplaced_ShadowFollows)
{
  BallScene scene;
  const Pixels before = scene.renderMask();
  const auto other = makeBall(-0.4, 1.2, 0.5);
  scene.ballActor->SetMapper(other->GetMapper());
  EXPECT_NE(scene.renderMask(), before);
  EXPECT_LE(scene.compare().wrongCertain, rimPixels);
}

TEST(PassChange, OneActorMoved_OnlyItsVolumeIsRebuilt)
{
  BallScene scene;
  const auto second = makeBall(-0.6, 1.2, 0.8);
  const auto third = makeBall(0.8, 0.7, 0.9);
  scene.renderer->AddActor(second);
  scene.renderer->AddActor(third);
  scene.window->Render();
  EXPECT_EQ(scene.pass->GetNumberOfRebuiltVolumes(), 3);
  expectNothingRebuilt(scene);
  second->SetPosition(0.1, 0.2, -0.1);
  scene.window->Render();
  EXPECT_EQ(scene.pass->GetNumberOfRebuiltVolumes(), 1);
  EXPECT_LE(scene.compare().wrongCertain, rimPixels);
  expectNothingRebuilt(scene);
}

TEST(PassChange, OneLightMoved_OnlyItsVolumesAreRebuilt)
{
  BallScene scene;
  scene.addPointLight(1.5, 4.0, 0.5);
  scene.window->Render();
  EXPECT_EQ(scene.pass->GetNumberOfRebuiltVolumes(), 2);
  scene.lamp->SetPosition(-1.4, 4.0, 0.1);
  scene.window->Render();
  EXPECT_EQ(scene.pass->GetNumberOfRebuiltVolumes(), 1);
  EXPECT_LE(scene.compare(0).wrongCertain, rimPixels);
  EXPECT_LE(scene.compare(1).wrongCertain, rimPixels);
}

TEST(PassChange, SilhouetteMethod_FindsAnewAndTheSameShadow)
{
  using Pass = vtkShadowVolumePass;
  BallScene scene;
  EXPECT_EQ(scene.pass->GetSilhouetteMethod(), Pass::SILHOUETTE_AUTO);
  const Pixels before = scene.renderMask();
  EXPECT_EQ(scene.pass->GetNumberOfCastersFoundBy(Pass::SILHOUETTE_BRUTE_FORCE), 1);
  EXPECT_EQ(scene.pass->GetNumberOfCastersFoundBy(Pass::SILHOUETTE_HIERARCHICAL), 0);
  scene.pass->SetSilhouetteMethodToHierarchical();
  EXPECT_EQ(scene.renderMask(), before);
  EXPECT_EQ(scene.pass->GetNumberOfRebuiltVolumes(), 1);
  EXPECT_EQ(scene.pass->GetNumberOfCastersFoundBy(Pass::SILHOUETTE_BRUTE_FORCE), 0);
  EXPECT_EQ(scene.pass->GetNumberOfCastersFoundBy(Pass::SILHOUETTE_HIERARCHICAL), 1);
  expectNothingRebuilt(scene);
  EXPECT_EQ(scene.pass->GetNumberOfCastersFoundBy(Pass::SILHOUETTE_HIERARCHICAL), 1);

  scene.pass->SetSilhouetteMethodToAuto();
  scene.ball->SetThetaResolution(200);
  scene.ball->SetPhiResolution(100);
  scene.window->Render();
  EXPECT_EQ(scene.pass->GetNumberOfCastersFoundBy(Pass::SILHOUETTE_HIERARCHICAL), 1);
}

TEST(PassChange, ActorsComeAndGo_MaskIsOfThoseThatAreThere)
{
  BallScene scene;
  const Pixels one = scene.renderMask();
  const auto second = makeBall(-0.6, 1.2, 0.8);
  scene.renderer->AddActor(second);
  const Pixels two = scene.renderMask();
  EXPECT_NE(two, one);
  second->VisibilityOff();
  EXPECT_EQ(scene.renderMask(), one);
  second->VisibilityOn();
  EXPECT_EQ(scene.renderMask(), two);
  scene.renderer->RemoveActor(second);
  EXPECT_EQ(scene.renderMask(), one);
}

TEST(PassCasting, Off_ReceivesButDoesNotCast)
{
  BallScene scene;
  EXPECT_EQ(scene.maskAt(BallScene::inShadow), 0);
  scene.pass->SetCasting(scene.ballActor, false);
  EXPECT_FALSE(scene.pass->GetCasting(scene.ballActor));
  EXPECT_EQ(scene.maskAt(BallScene::inShadow), 255);
  EXPECT_EQ(scene.pass->GetNumberOfCasters(), 0);
  EXPECT_LE(scene.compare().wrongCertain, rimPixels);

  // Another caster above the ball still shadows it.
  const auto lid = makeBall(-0.3, 2.2, 0.0);
  scene.renderer->AddActor(lid);
  EXPECT_LE(scene.compare().wrongCertain, rimPixels);
  scene.renderer->RemoveActor(lid);

  scene.pass->SetCasting(scene.ballActor, true);
  EXPECT_TRUE(scene.pass->GetCasting(scene.ballActor));
  EXPECT_EQ(scene.maskAt(BallScene::inShadow), 0);
}

TEST(PassCasting, OfAssembly_HoldsForItsPartsAndForOneAlone)
{
  BallScene scene;
  scene.renderer->RemoveActor(scene.ballActor);
  const auto left = makeBall(-0.7, 1.0, 0.0);
  const auto right = makeBall(0.7, 1.0, 0.0);
  vtkNew<vtkAssembly> inner;
  inner->AddPart(left);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(inner);
  assembly->AddPart(right);
  assembly->SetScale(1.0, 1.2, 0.8);
  assembly->RotateY(20.0);
  scene.renderer->AddActor(assembly);
  const auto casters = [&]
  {
    scene.window->Render();
    EXPECT_LE(scene.compare().wrongCertain, rimPixels);
    return scene.pass->GetNumberOfCasters();
  };
  EXPECT_EQ(casters(), 2);
  scene.pass->SetCasting(right, false);
  EXPECT_EQ(casters(), 1);
  scene.pass->SetCasting(inner, false);
  EXPECT_EQ(casters(), 0);
  scene.pass->SetCasting(right, true);
  EXPECT_EQ(casters(), 1);
  scene.pass->SetCasting(inner, true);
  scene.pass->SetCasting(assembly, false);
  EXPECT_EQ(casters(), 0);
  scene.pass->SetCasting(assembly, true);
  EXPECT_EQ(casters(), 2);
}

TEST(PassCasting, OfDeletedProp_DoesNotStickToAnotherAtItsAddress)
{
  BallScene scene;
  for (int i = 0; i < 20; ++i)
  {
    scene.pass->SetCasting(makeBall(0.0, 0.0, 0.0), false);
    EXPECT_TRUE(scene.pass->GetCasting(makeBall(0.0, 0.0, 0.0)));
  }
}
