// Whatever way a surface is shaded: in shadow it has its ambient part only, elsewhere it is as VTK draws it.

#include <gtest/gtest.h>

#include <vtkCellData.h>
#include <vtkElevationFilter.h>
#include <vtkImageData.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

#include "BallScene.h"

using namespace shadow::test;

namespace
{

/// The table's pixel in the ball's shadow and one in the light, against renderings without casting or light.
void expectShadowed(BallScene& scene, double darkening = 15.0)
{
  const auto messages = MessageCounter::observe(scene.pass);
  const double shadowed = scene.greyAt(BallScene::inShadow);
  const double lit = scene.greyAt(BallScene::lit);
  EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_OK) << scene.pass->GetStatusMessage();
  scene.lamp->SetIntensity(0.0);
  EXPECT_NEAR(shadowed, scene.greyAt(BallScene::inShadow), 1.1) << "more or less than the ambient part";
  scene.lamp->SetIntensity(1.0);
  scene.pass->SetCasting(scene.ballActor, false);
  EXPECT_LT(shadowed, scene.greyAt(BallScene::inShadow) - darkening);
  attachPlainSteps(scene.renderer);
  EXPECT_NEAR(lit, scene.greyAt(BallScene::lit), 1.1);
  EXPECT_EQ(messages->warnings + messages->errors, 0) << messages->last;
  scene.pass->SetCasting(scene.ballActor, true);
  scene.renderer->SetPass(scene.pass);
}

void expectShadowedInBoth(BallScene& scene, double darkening = 15.0)
{
  expectShadowed(scene, darkening);
  scene.pass->SetCompositingToAdditive();
  expectShadowed(scene, darkening);
}

void addNormals(BallScene& scene, vtkPolyDataNormals* normals)
{
  normals->SetInputConnection(scene.table->GetMapper()->GetInputConnection(0, 0));
  scene.table->GetMapper()->SetInputConnection(normals->GetOutputPort());
}

} // namespace

TEST(PassMaterial, Flat_Shadowed)
{
  BallScene scene;
  scene.table->GetProperty()->SetInterpolationToFlat();
  expectShadowedInBoth(scene);
}

TEST(PassMaterial, Smooth_Shadowed)
{
  BallScene scene;
  vtkNew<vtkPolyDataNormals> normals;
  addNormals(scene, normals);
  scene.table->GetProperty()->SetInterpolationToPhong();
  scene.table->GetProperty()->SetSpecular(0.5);
  scene.table->GetProperty()->SetSpecularPower(10.0);
  expectShadowedInBoth(scene);
}

TEST(PassMaterial, SpecularOnly_HighlightGoesIntoTheShadow)
{
  BallScene scene;
  scene.table->GetProperty()->SetDiffuse(0.0);
  scene.table->GetProperty()->SetSpecular(1.0);
  scene.table->GetProperty()->SetSpecularPower(1.0);
  expectShadowedInBoth(scene);
}

TEST(PassMaterial, PhysicallyBased_Shadowed)
{
  BallScene scene;
  scene.renderer->RemoveLight(scene.lamp);
  scene.lamp = scene.addDirectionalLight(0.5, -1.0, 0.0);
  scene.lamp->SetIntensity(1.0);
  scene.table->GetProperty()->SetInterpolationToPBR();
  scene.table->GetProperty()->SetRoughness(0.6);
  scene.ballActor->GetProperty()->SetInterpolationToPBR();
  scene.ballActor->GetProperty()->SetMetallic(0.5);
  expectShadowedInBoth(scene);
}

TEST(PassMaterial, PhysicallyBasedUnderPointLight_Shadowed)
{
  BallScene scene;
  scene.table->GetProperty()->SetInterpolationToPBR();
  // Physically based point lights fade with the distance.
  expectShadowedInBoth(scene, 1.5);
}

TEST(PassMaterial, Textured_Shadowed)
{
  BallScene scene;
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* colours = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 12; ++i)
  {
    colours[i] = static_cast<unsigned char>(120 + 10 * i);
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOn();
  scene.table->SetTexture(texture);
  expectShadowedInBoth(scene);
}

// VTK leaves out what has no alpha, and takes the actor for opaque, if something has; the shadow is that of
// its triangles.
TEST(PassMaterial, TextureWithHoles_CastsAsWholeFaces)
{
  BallScene scene;
  const auto texture = makeTextureOfHoles();
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-0.4, 1.0, 0.4);
  plane->SetPoint1(0.4, 1.0, 0.4);
  plane->SetPoint2(-0.4, 1.0, -0.4);
  scene.ballActor->VisibilityOff();
  EXPECT_EQ(scene.maskAt(BallScene::inShadow), 255);
  const double lit = scene.greyAt(BallScene::inShadow);
  vtkActor* plate = scene.addSource(plane);
  plate->SetTexture(texture);
  EXPECT_EQ(scene.maskAt(BallScene::inShadow), 0);
  EXPECT_LT(scene.greyAt(BallScene::inShadow), 0.8 * lit);
  EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_OK);
}

TEST(PassMaterial, ScalarColoured_Shadowed)
{
  BallScene scene;
  vtkNew<vtkElevationFilter> elevation;
  elevation->SetInputConnection(scene.table->GetMapper()->GetInputConnection(0, 0));
  elevation->SetLowPoint(-2.0, 0.0, 0.0);
  elevation->SetHighPoint(2.0, 0.0, 0.0);
  scene.table->GetMapper()->SetInputConnection(elevation->GetOutputPort());
  for (const bool interpolate : {false, true})
  {
    scene.table->GetMapper()->SetInterpolateScalarsBeforeMapping(interpolate);
    expectShadowedInBoth(scene);
  }
}

TEST(PassMaterial, CellColoured_Shadowed)
{
  BallScene scene;
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(-2.0, 0.0, 2.0);
  source->SetPoint1(2.0, 0.0, 2.0);
  source->SetPoint2(-2.0, 0.0, -2.0);
  source->SetResolution(5, 5);
  source->Update();
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  for (int i = 0; i < 25; ++i)
  {
    colours->InsertNextTuple3(100 + 5 * i, 200, 255 - 5 * i);
  }
  source->GetOutput()->GetCellData()->SetScalars(colours);
  vtkPolyDataMapper::SafeDownCast(scene.table->GetMapper())->SetInputData(source->GetOutput());
  expectShadowedInBoth(scene);
}

TEST(PassMaterial, WithEdges_Shadowed)
{
  BallScene scene;
  scene.table->GetProperty()->EdgeVisibilityOn();
  scene.ballActor->GetProperty()->EdgeVisibilityOn();
  expectShadowedInBoth(scene);
}

TEST(PassMaterial, WithBackfaceProperty_Shadowed)
{
  BallScene scene;
  vtkNew<vtkProperty> back;
  back->SetColor(1.0, 0.0, 0.0);
  scene.table->SetBackfaceProperty(back);
  scene.ballActor->SetBackfaceProperty(back);
  expectShadowedInBoth(scene);
}

TEST(PassMaterial, Unlit_Unchanged)
{
  BallScene scene;
  scene.table->GetProperty()->LightingOff();
  for (const int compositing :
       {vtkShadowVolumePass::COMPOSITING_MASK, vtkShadowVolumePass::COMPOSITING_ADDITIVE})
  {
    scene.renderer->SetPass(scene.pass);
    scene.pass->SetCompositing(compositing);
    const double shadowed = scene.greyAt(BallScene::inShadow);
    const double lit = scene.greyAt(BallScene::lit);
    attachPlainSteps(scene.renderer);
    EXPECT_EQ(shadowed, scene.greyAt(BallScene::inShadow));
    EXPECT_EQ(lit, scene.greyAt(BallScene::lit));
    EXPECT_EQ(shadowed, lit);
    EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_OK) << scene.pass->GetStatusMessage();
  }
}

TEST(PassMaterial, ChangedBetweenRenderings_Shadowed)
{
  BallScene scene;
  expectShadowed(scene);
  scene.table->GetProperty()->SetInterpolationToPBR();
  expectShadowed(scene, 1.5);
  scene.table->GetProperty()->SetInterpolationToFlat();
  expectShadowed(scene);
  scene.addPointLight(1.0, 3.0, 1.0)->SetIntensity(0.0);
  expectShadowed(scene);
  scene.pass->SetSamples(4);
  expectShadowed(scene);
}
