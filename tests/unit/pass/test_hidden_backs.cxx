// Backs of large meshes that no pixel shows are left out, and only those: the picture is that of a scene
// where a shader of its own on the table keeps the pass from leaving anything out.

#include <algorithm>

#include <gtest/gtest.h>

#include <vtkAssembly.h>
#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkCylinderSource.h>
#include <vtkImageData.h>
#include <vtkLightCollection.h>
#include <vtkProperty.h>
#include <vtkReverseSense.h>
#include <vtkShaderProperty.h>
#include <vtkTexture.h>

#include "BallScene.h"

using namespace shadow::test;

namespace
{

/// A ball of 39,600 triangles.
class LargeBallScene : public BallScene
{
public:
  LargeBallScene()
  {
    this->ball->SetThetaResolution(200);
    this->ball->SetPhiResolution(100);
    this->ballActor->GetProperty()->SetColor(0.9, 0.3, 0.2);
  }

  /// Takes off the ball's cap, and looks into it from above.
  void lookInside()
  {
    this->takeCapOff();
    this->renderer->GetActiveCamera()->SetPosition(0.0, 6.0, 1.0);
  }

  /// Takes the ball's cap off; it points up.
  void takeCapOff()
  {
    this->ball->SetStartPhi(60.0);
    this->ballActor->SetOrigin(0.0, 1.0, 0.0);
    this->ballActor->RotateX(-90.0);
  }

  /// Renders twice, the second time with the lamp elsewhere and all else where it was.
  /// @param hidden  actors whose backs are left out, see expectHiddenBacks()
  void expectWholePicture(int hidden)
  {
    Pixels pictures[2];
    for (Pixels& picture : pictures)
    {
      this->moveLamp();
      picture = this->renderPicture();
      this->expectHiddenBacks(hidden);
    }
    this->table->ForceOpaqueOn();
    for (const Pixels& picture : {pictures[1], pictures[0]})
    {
      EXPECT_EQ(countDifferent(picture, this->renderPicture()), 0U);
      EXPECT_EQ(this->pass->GetNumberOfHiddenBacks(), 0);
      this->moveLamp();
    }
    this->table->ForceOpaqueOff();
    EXPECT_EQ(this->pass->GetStatus(), vtkShadowVolumePass::STATUS_OK);
  }

private:
  /// Back and forth.
  void moveLamp()
  {
    this->moved = !this->moved;
    this->lamp->SetPosition(this->moved ? -1.2 : -1.5, 4.0, 0.0);
  }

  bool moved = false;
};

} // namespace

TEST(HiddenBacks, ClosedMesh_LeftOut)
{
  LargeBallScene scene;
  scene.expectWholePicture(1);
}

TEST(HiddenBacks, SmallMesh_NotAskedAbout)
{
  LargeBallScene scene;
  scene.ball->SetThetaResolution(20);
  scene.expectWholePicture(0);
}

TEST(HiddenBacks, MeshThatIsLookedInto_Drawn)
{
  LargeBallScene scene;
  scene.lookInside();
  scene.expectWholePicture(0);
}

TEST(HiddenBacks, MeshWhoseOpeningTurnsAway_LeftOutFromThenOn)
{
  LargeBallScene scene;
  scene.lookInside();
  scene.expectWholePicture(0);
  scene.ballActor->RotateX(180.0);
  scene.expectWholePicture(1);
  scene.ballActor->RotateX(180.0);
  scene.expectWholePicture(0);
}

TEST(HiddenBacks, OpeningThatIsUncovered_Drawn)
{
  LargeBallScene scene;
  scene.lookInside();
  vtkNew<vtkCubeSource> cube;
  cube->SetCenter(0.0, 1.8, 0.1);
  vtkActor* lid = scene.addSource(cube);
  scene.expectWholePicture(1);
  lid->SetPosition(-1.0, 0.0, 0.0);
  scene.expectWholePicture(0);
}

TEST(HiddenBacks, NearPlaneCutsTheMesh_Drawn)
{
  LargeBallScene scene;
  vtkCamera* camera = scene.renderer->GetActiveCamera();
  const double distance = camera->GetDistance();
  camera->SetClippingRange(distance - 0.3, distance + 10.0);
  scene.expectWholePicture(0);
}

TEST(HiddenBacks, MirroredActor_LeftOut)
{
  LargeBallScene scene;
  scene.ballActor->SetScale(-1.0, 1.0, 1.0);
  scene.expectWholePicture(1);
}

TEST(HiddenBacks, MeshWoundInwards_LeftOut)
{
  LargeBallScene scene;
  vtkNew<vtkReverseSense> reverse;
  reverse->SetInputConnection(scene.ball->GetOutputPort());
  scene.ballActor->SetVisibility(0);
  scene.addSource(reverse);
  scene.expectWholePicture(1);
}

TEST(HiddenBacks, Additive_LeftOutInEveryPass)
{
  LargeBallScene scene;
  scene.pass->SetCompositingToAdditive();
  scene.expectWholePicture(1);
}

TEST(HiddenBacks, PropAfterTheMesh_ShowsItsBack)
{
  LargeBallScene scene;
  vtkNew<vtkCylinderSource> tube;
  tube->CappingOff();
  tube->SetCenter(1.0, 0.5, 0.5);
  scene.addSource(tube);
  scene.expectWholePicture(1);
}

TEST(HiddenBacks, ActorInTwoPlaces_DrawnWhole)
{
  LargeBallScene scene;
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(scene.ballActor);
  assembly->SetPosition(-1.2, 0.0, 0.0);
  scene.renderer->AddViewProp(assembly);
  scene.expectWholePicture(0);
}

TEST(HiddenBacks, CulledByItsProperty_NotAskedAbout)
{
  LargeBallScene scene;
  scene.ballActor->GetProperty()->BackfaceCullingOn();
  scene.expectWholePicture(0);
}

TEST(HiddenBacks, SeveralLightsAndAllBitsTaken)
{
  LargeBallScene scene;
  while (scene.renderer->GetLights()->GetNumberOfItems() < 31)
  {
    const double x = -2.0 + 0.13 * scene.renderer->GetLights()->GetNumberOfItems();
    scene.addPointLight(x, 5.0, 1.0)->SetIntensity(0.02);
  }
  scene.expectWholePicture(1);
  scene.addPointLight(2.1, 5.0, 1.0)->SetIntensity(0.02);
  scene.expectWholePicture(0);
}

TEST(HiddenBacks, ShaderOfAnActorsOwn_NothingLeftOut)
{
  LargeBallScene scene;
  scene.table->GetShaderProperty()->AddFragmentShaderReplacement(
      "//VTK::Normal::Impl", true, "  if (vertexVC.x > 0.0) { discard; }\n//VTK::Normal::Impl\n", false);
  scene.expectWholePicture(0);
}

TEST(HiddenBacks, TextureThatMayHaveHoles_NothingLeftOut)
{
  LargeBallScene scene;
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 16, static_cast<unsigned char>(255));
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  scene.table->SetTexture(texture);
  scene.expectWholePicture(0);
}

TEST(HiddenBacks, MultisampledWindow_NothingLeftOut)
{
  LargeBallScene scene;
  const Pixels jagged = scene.renderPicture();
  scene.expectHiddenBacks(1);
  scene.window->SetMultiSamples(4);
  const Pixels smooth = scene.renderPicture();
  EXPECT_GT(countDifferent(jagged, smooth, 10), 100U) << "the window has one sample a pixel";
  scene.expectWholePicture(0);
  scene.pass->SetSamples(4);
  scene.expectWholePicture(0);
}

TEST(HiddenBacks, SeveralSamplesOfTheMask_NothingLeftOut)
{
  LargeBallScene scene;
  scene.pass->SetSamples(4);
  scene.expectWholePicture(0);
  scene.pass->SetSamples(1);
  scene.expectWholePicture(1);
}

TEST(HiddenBacks, ParallelProjection_LeftOut)
{
  LargeBallScene scene;
  vtkCamera* camera = scene.renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(2.0);
  scene.expectWholePicture(1);
}

TEST(HiddenBacks, ActorsOfOneMeshThatChangePlaces_EachAskedAboutAnew)
{
  LargeBallScene scene;
  scene.lookInside();
  const auto lookAway = [](vtkActor* actor, double angle, double x)
  {
    actor->SetOrientation(0.0, 0.0, 0.0);
    actor->RotateX(angle);
    actor->SetPosition(x, 0.0, 0.0);
  };
  vtkNew<vtkActor> other;
  other->SetMapper(scene.ballActor->GetMapper());
  other->SetOrigin(scene.ballActor->GetOrigin());
  scene.renderer->AddActor(other);
  lookAway(scene.ballActor, -90.0, -0.6);
  lookAway(other, 90.0, 0.6);
  scene.expectWholePicture(1);
  // The same meshes in the same places in the same order, but of other actors.
  lookAway(other, -90.0, -0.6);
  lookAway(scene.ballActor, 90.0, 0.6);
  const vtkSmartPointer<vtkActor> kept = scene.ballActor;
  scene.renderer->RemoveActor(kept);
  scene.renderer->AddActor(kept);
  scene.expectWholePicture(1);
}
