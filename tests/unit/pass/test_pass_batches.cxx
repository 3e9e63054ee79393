// Small meshes drawn together: the same masks, pictures and counts, to the bit, as drawn one by one.

#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <vtkCamera.h>
#include <vtkConeSource.h>
#include <vtkCubeSource.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>

#include "NewPass.h"
#include "ShadowScene.h"

using namespace shadow::truth;

namespace
{

using Pass = vtkShadowVolumePass;

/// Boxes, instances of one ball, some of them mirrored, an open sheet, and a ball too large for a batch on a floor
/// under a point light and a directional one.
struct BatchScene : ShadowScene
{
  BatchScene() : ShadowScene(160, 120)
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetRadius(0.3);
    ball->SetThetaResolution(9);
    ball->SetPhiResolution(9);
    vtkNew<vtkPolyDataMapper> instances;
    instances->SetInputConnection(ball->GetOutputPort());
    for (int i = 0; i < 12; ++i)
    {
      vtkActor* actor = nullptr;
      if (i % 2 == 0)
      {
        vtkNew<vtkCubeSource> box;
        box->SetXLength(0.3 + 0.05 * i);
        actor = this->addSource(box);
        actor->RotateWXYZ(20.0 * i, 1.0, 0.4, 0.2);
      }
      else
      {
        actor = this->addMapper(instances);
        actor->SetScale(i % 4 == 1 ? 1.0 : -1.0, 1.0, 0.7);
      }
      actor->SetPosition(1.1 * (i % 4), 0.7, 1.1 * (i / 4));
      this->small.push_back(actor);
    }
    vtkNew<vtkPlaneSource> sheet;
    sheet->SetOrigin(-1.0, 0.5, -1.0);
    sheet->SetPoint1(0.2, 1.2, -1.0);
    sheet->SetPoint2(-1.0, 0.6, 0.5);
    this->small.push_back(this->addSource(sheet));
    vtkNew<vtkSphereSource> fineBall;
    fineBall->SetThetaResolution(40);
    fineBall->SetPhiResolution(40);
    fineBall->SetCenter(4.6, 0.8, 1.0);
    this->large = this->addSource(fineBall);
    this->floor = this->addFloor(1.6);
    this->lookFrom(-0.4, 0.7, 1.0, 1.0);
    this->lamp = this->addPointLight(0.4, 4.0, 3.5);
    this->addDirectionalLight(0.4, -1.0, 0.3);
  }

  std::vector<vtkActor*> small;
  vtkActor* large = nullptr;
  vtkActor* floor = nullptr;
  vtkLight* lamp = nullptr;
};

/// Expects what a new pass draws that has no savings. @return meshes drawn together
int expectAsDrawnAlone(BatchScene& scene)
{
  const DrawnShadows drawn = drawShadows(scene.window, scene.pass);
  const int batched = scene.pass->GetNumberOfBatchedMeshes();
  EXPECT_EQ(tellDifferences(drawn, drawByNewPass(scene.window, scene.pass)), "");
  return batched;
}

/// Something that a program does to a scene, once or between two frames.
struct Step
{
  std::string name;
  std::function<void(BatchScene&)> take;
  int batched = 14; ///< with the floor and the sheet
};

std::vector<Step> settings()
{
  return {
      {"Nothing", [](BatchScene&) {}},
      {"ZPass", [](BatchScene& s) { s.pass->SetStencilMethodToZPass(); }},
      {"ZFail", [](BatchScene& s) { s.pass->SetStencilMethodToZFail(); }},
      {"Stencil", [](BatchScene& s) { s.pass->SetCountBufferToStencil(); }},
      {"ZFailInStencil",
       [](BatchScene& s)
       {
         s.pass->SetCountBufferToStencil();
         s.pass->SetStencilMethodToZFail();
       }},
      {"Color", [](BatchScene& s) { s.pass->SetCountBufferToColor(); }},
      {"Additive", [](BatchScene& s) { s.pass->SetCompositingToAdditive(); }},
      {"FourSamples", [](BatchScene& s) { s.pass->SetSamples(4); }},
      {"Parallel", [](BatchScene& s) { s.renderer->GetActiveCamera()->ParallelProjectionOn(); }},
      {"ParallelZFail",
       [](BatchScene& s)
       {
         s.renderer->GetActiveCamera()->ParallelProjectionOn();
         s.pass->SetStencilMethodToZFail();
       }},
      {"Mirrored", [](BatchScene& s) { s.renderer->GetActiveCamera()->SetViewShear(0.2, 0.1, 1.0); }},
      {"Triangular", [](BatchScene& s) { s.pass->SetSilhouetteMethodToTriangular(); }},
      {"Compute", [](BatchScene& s) { s.pass->SetSilhouetteMethod(Pass::SILHOUETTE_COMPUTE); }, 0},
      {"FacingTexture", [](BatchScene& s) { s.pass->SetSilhouetteMethod(Pass::SILHOUETTE_FACING_TEXTURE); }, 0},
      {"BatchesOff", [](BatchScene& s) { s.pass->SetSavings(Pass::SAVINGS_KEPT_MASKS); }, 0},
      {"LightInsideABall", [](BatchScene& s) { s.lamp->SetPosition(1.1, 0.72, 0.01); }},
      {"LightOnASide", [](BatchScene& s) { s.lamp->SetPosition(0.0, 1.2 + 1e-9, 0.0); }},
      {"EyeInAShadow",
       [](BatchScene& s)
       {
         s.renderer->GetActiveCamera()->SetPosition(1.2, 0.1, 1.0);
         s.renderer->GetActiveCamera()->SetFocalPoint(4.0, 0.3, 1.5);
         s.renderer->ResetCameraClippingRange();
       }},
      {"CulledBacks", [](BatchScene& s) { s.small[0]->GetProperty()->BackfaceCullingOn(); }, 13},
      {"CulledFronts", [](BatchScene& s) { s.small[3]->GetProperty()->FrontfaceCullingOn(); }, 13},
      {"OneSmallMesh",
       [](BatchScene& s)
       {
         for (vtkActor* actor : s.small)
         {
           actor->SetVisibility(actor == s.small[0]);
         }
         s.floor->GetProperty()->BackfaceCullingOn();
       },
       0},
      {"SomeCastNothing",
       [](BatchScene& s)
       {
         for (std::size_t i = 0; i < s.small.size(); i += 3)
         {
           s.pass->SetCasting(s.small[i], false);
         }
       }},
  };
}

void deform(BatchScene& scene, double by)
{
  auto* mapper = vtkPolyDataMapper::SafeDownCast(scene.small[2]->GetMapper());
  vtkNew<vtkPolyData> moved;
  moved->DeepCopy(mapper->GetInput());
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    double point[3];
    moved->GetPoint(i, point);
    moved->GetPoints()->SetPoint(i, point[0] * (1.0 + by), point[1] + by * point[0], point[2]);
  }
  mapper->SetInputData(moved);
}

std::vector<Step> changes()
{
  return {
      {"Camera", [](BatchScene& s) { s.renderer->GetActiveCamera()->Azimuth(20.0); }},
      {"CameraAway", [](BatchScene& s) { s.renderer->GetActiveCamera()->Yaw(25.0); }},
      {"Light", [](BatchScene& s) { s.lamp->SetPosition(3.0, 3.5, -1.0); }},
      {"LightAdded", [](BatchScene& s) { s.addPointLight(2.0, 5.0, 0.0); }},
      {"LightOff", [](BatchScene& s) { s.lamp->SwitchOff(); }},
      {"Actor", [](BatchScene& s) { s.small[4]->AddPosition(0.2, 0.3, 0.1); }},
      {"ActorMirrored", [](BatchScene& s) { s.small[1]->SetScale(-1.0, 1.0, 1.0); }},
      {"ActorHidden", [](BatchScene& s) { s.small[5]->VisibilityOff(); }, 13},
      {"ActorRemoved", [](BatchScene& s) { s.renderer->RemoveActor(s.small[6]); }, 13},
      {"ActorAdded",
       [](BatchScene& s)
       {
         vtkNew<vtkConeSource> cone;
         cone->SetCenter(2.0, 1.6, 1.0);
         s.addSource(cone);
       },
       15},
      {"MeshDeforms", [](BatchScene& s) { deform(s, 0.1); }},
      {"MeshTurnsInsideOut", [](BatchScene& s) { deform(s, -2.0); }},
      {"MeshGrowsTooLarge",
       [](BatchScene& s)
       {
         vtkNew<vtkSphereSource> ball;
         ball->SetThetaResolution(30);
         ball->SetPhiResolution(30);
         s.small[2]->GetMapper()->SetInputConnection(ball->GetOutputPort());
       },
       13},
      {"WindowSize", [](BatchScene& s) { s.window->SetSize(120, 150); }},
      {"CountBuffer", [](BatchScene& s) { s.pass->SetCountBufferToStencil(); }},
      {"BatchesOff", [](BatchScene& s) { s.pass->SetSavings(0); }, 0},
      {"ResourcesReleased", [](BatchScene& s) { s.pass->ReleaseGraphicsResources(s.window); }},
  };
}

class BatchSetting : public testing::TestWithParam<Step>
{
};

class BatchChange : public testing::TestWithParam<Step>
{
};

std::string nameOf(const testing::TestParamInfo<Step>& info)
{
  return info.param.name;
}

} // namespace

TEST_P(BatchSetting, DrawnTogether_AsDrawnAlone)
{
  BatchScene scene;
  GetParam().take(scene);
  EXPECT_EQ(expectAsDrawnAlone(scene), GetParam().batched);
}
INSTANTIATE_TEST_SUITE_P(Pass, BatchSetting, testing::ValuesIn(settings()), nameOf);

TEST_P(BatchChange, Afterwards_AsDrawnAlone)
{
  BatchScene scene;
  expectAsDrawnAlone(scene);
  GetParam().take(scene);
  EXPECT_EQ(expectAsDrawnAlone(scene), GetParam().batched);
  // And back again, as far as there is a way.
  scene.renderer->GetActiveCamera()->Elevation(5.0);
  scene.pass->SetSavings(Pass::SAVINGS_ALL);
  expectAsDrawnAlone(scene);
}
INSTANTIATE_TEST_SUITE_P(Pass, BatchChange, testing::ValuesIn(changes()), nameOf);

// 300 boxes over each other: a stencil counts to 255 only.
TEST(Batches, MoreThanAStencilCounts_AsDrawnAlone)
{
  for (const int buffer : {Pass::COUNT_STENCIL, Pass::COUNT_COLOR})
  {
    ShadowScene scene(64, 64);
    for (int i = 0; i < 300; ++i)
    {
      vtkNew<vtkCubeSource> box;
      box->SetYLength(0.001);
      box->SetCenter(0.0, 1.0 + 0.01 * i, 0.0);
      scene.addSource(box);
    }
    scene.addFloor();
    scene.addDirectionalLight(0.1, -1.0, 0.2);
    scene.lookFrom(0.3, 0.8, 1.0, 1.5);
    scene.pass->SetCountBuffer(buffer);
    const DrawnShadows drawn = drawShadows(scene.window, scene.pass);
    EXPECT_EQ(scene.pass->GetNumberOfBatchedMeshes(), 301);
    EXPECT_EQ(tellDifferences(drawn, drawByNewPass(scene.window, scene.pass)), "");
    EXPECT_EQ(scene.compare(0, true).wrongCertain, 0u);
  }
}
