// What the pass cannot shadow is told and drawn; what VTK hides casts nothing; wrong calls give one error.

#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <string>

#include <vtkCamera.h>
#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPlane.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include "BallScene.h"
#include "CompositeMapper.h"

using namespace shadow::test;

namespace
{

std::string skippedCasters(vtkShadowVolumePass* pass)
{
  std::string all;
  for (int i = 0; i < pass->GetNumberOfSkippedCasters(); ++i)
  {
    all += pass->GetSkippedCaster(i) + "\n";
  }
  return all;
}

/// Renders, and looks for the words among the skipped casters.
void expectSkipped(BallScene& scene, const std::string& words)
{
  scene.window->Render();
  EXPECT_NE(skippedCasters(scene.pass).find(words), std::string::npos) << "\"" << words << "\" is not in:\n"
                                                                       << skippedCasters(scene.pass);
}

vtkSmartPointer<vtkPolyData> ballAt(double x, double y, double z)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(x, y, z);
  source->Update();
  return source->GetOutput();
}

} // namespace

TEST(PassReport, Translucent_ReportedAndCastsNothing)
{
  BallScene scene;
  scene.ballActor->GetProperty()->SetOpacity(0.5);
  EXPECT_EQ(scene.maskAt(BallScene::inShadow), 255);
  expectSkipped(scene, "translucent");
  EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_OK) << "that is as documented, no failure";
  scene.ballActor->GetProperty()->SetOpacity(1.0);
  EXPECT_EQ(scene.maskAt(BallScene::inShadow), 0);
  EXPECT_EQ(skippedCasters(scene.pass).find("translucent"), std::string::npos);
}

TEST(PassReport, Wireframe_ReportedAndDrawnAsWithoutShadows)
{
  BallScene scene;
  scene.ballActor->GetProperty()->SetRepresentationToWireframe();
  EXPECT_EQ(scene.maskAt(BallScene::inShadow), 255);
  expectSkipped(scene, "not drawn as a surface");
  const Pixels picture = scene.renderPicture();
  attachPlainSteps(scene.renderer);
  EXPECT_EQ(countDifferent(scene.renderPicture(), picture, 1), 0u);
}

TEST(PassReport, Glyphs_ReportedAndDrawnUnshadowed)
{
  BallScene scene;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.5, 0.15, 0.0); // in the ball's shadow
  points->InsertNextPoint(-1.2, 0.15, 0.8);
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  vtkNew<vtkSphereSource> shape;
  shape->SetRadius(0.15);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(places);
  mapper->SetSourceConnection(shape->GetOutputPort());
  vtkNew<vtkActor> glyphs;
  glyphs->SetMapper(mapper);
  glyphs->GetProperty()->SetColor(1.0, 0.0, 0.0);
  glyphs->GetProperty()->SetAmbient(0.1);
  glyphs->GetProperty()->SetDiffuse(0.9);
  scene.renderer->AddActor(glyphs);
  expectSkipped(scene, "Glyph3DMapper");
  EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_PARTIAL);
  EXPECT_NE(std::string(scene.pass->GetStatusMessage()).find("Glyph3DMapper"), std::string::npos);
  for (const glm::dvec3& place : {glm::dvec3(0.45, 0.28, 0.05), glm::dvec3(-1.2, 0.28, 0.85)})
  {
    scene.renderer->SetPass(scene.pass);
    const std::array<int, 3> colour = scene.colourAt(place);
    attachPlainSteps(scene.renderer);
    const std::array<int, 3> plain = scene.colourAt(place);
    EXPECT_GT(plain[0], 150) << "not the glyph, or not lit";
    EXPECT_NEAR(colour[0], plain[0], 1);
    EXPECT_NEAR(colour[1], plain[1], 1);
  }
  scene.renderer->SetPass(scene.pass);
  EXPECT_EQ(scene.maskAt(BallScene::inShadow), 0) << "the ball still shadows the table";
}

TEST(PassReport, UnusableData_ReportedOnceAndTheRestIsShadowed)
{
  BallScene scene;
  const vtkSmartPointer<vtkPolyData> broken = ballAt(0.0, 0.5, 1.5);
  broken->GetPoints()->SetPoint(5, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  broken->GetPoints()->SetPoint(9, std::numeric_limits<double>::infinity(), 0.0, 0.0);
  scene.addPolyData(broken);
  const auto messages = MessageCounter::observe(scene.pass);
  EXPECT_EQ(scene.maskAt(BallScene::inShadow), 0);
  EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_PARTIAL);
  EXPECT_FALSE(scene.pass->GetStatusMessage().empty());
  scene.window->Render();
  EXPECT_EQ(messages->warnings, 1) << "the same cause is told once";
}

TEST(PassReport, EmptyScenes_NoErrorAndAllLit)
{
  BallScene scene;
  const auto messages = MessageCounter::observe(scene.pass);
  vtkNew<vtkActor> noMapper;
  scene.renderer->AddActor(noMapper);
  vtkNew<vtkPolyDataMapper> noInput;
  vtkNew<vtkActor> noData;
  noData->SetMapper(noInput);
  scene.renderer->AddActor(noData);
  vtkNew<vtkPolyData> nothing;
  scene.addPolyData(nothing);
  EXPECT_EQ(scene.maskAt(BallScene::inShadow), 0);
  scene.renderer->RemoveAllViewProps();
  EXPECT_EQ(countValue(scene.renderMask(), 255), 200u * 150u);
  scene.renderer->RemoveAllLights();
  scene.window->Render();
  EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_OK) << scene.pass->GetStatusMessage();
  EXPECT_EQ(messages->errors + messages->warnings, 0) << messages->last;
}

TEST(PassReport, WrongCalls_OneErrorEachAndNoCrash)
{
  BallScene scene;
  const auto messages = MessageCounter::observe(scene.pass);
  scene.pass->SetCasting(nullptr, false);
  EXPECT_EQ(messages->errors, 1);
  EXPECT_TRUE(scene.pass->GetCasting(nullptr));
  vtkNew<vtkImageData> image;
  EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_NOT_RENDERED);
  EXPECT_FALSE(scene.pass->GetShadowMask(0, image));
  EXPECT_EQ(messages->errors, 2) << "nothing has been rendered";
  scene.window->Render();
  int errors = 2;
  for (const int light : {-1, 1, 99})
  {
    EXPECT_FALSE(scene.pass->GetShadowMask(light, image));
    EXPECT_EQ(messages->errors, ++errors) << light;
  }
  EXPECT_FALSE(scene.pass->GetShadowMask(0, nullptr));
  EXPECT_EQ(messages->errors, ++errors);
  EXPECT_EQ(scene.pass->GetSkippedCaster(-1), "");
  EXPECT_EQ(scene.pass->GetSkippedCaster(1000), "");
  EXPECT_EQ(scene.maskAt(BallScene::inShadow), 0);
  EXPECT_EQ(messages->errors, errors);
}

TEST(PassReport, SettingsAreClampedAndPrinted)
{
  vtkNew<vtkShadowVolumePass> pass;
  pass->SetShadowIntensity(7.0);
  EXPECT_EQ(pass->GetShadowIntensity(), 1.0);
  pass->SetSamples(-1);
  EXPECT_EQ(pass->GetSamples(), 0);
  pass->SetSamples(33);
  EXPECT_EQ(pass->GetSamples(), 32);
  pass->SetStencilMethod(99);
  EXPECT_EQ(pass->GetStencilMethod(), vtkShadowVolumePass::STENCIL_ZFAIL);
  std::ostringstream text;
  pass->Print(text);
  EXPECT_NE(text.str().find("ShadowIntensity"), std::string::npos);
}

TEST(PassHidden, ClippingPlanesInTheWorld_TransformedActor_MaskIsTheTruth)
{
  BallScene scene;
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 1.0, 0.0);
  plane->SetNormal(0.6, 0.8, 0.0);
  vtkNew<vtkPlane> second;
  second->SetOrigin(0.0, 0.0, -0.2);
  second->SetNormal(0.0, 0.0, 1.0);
  const Pixels whole = scene.renderMask();
  scene.ballActor->GetMapper()->AddClippingPlane(plane);
  scene.ballActor->GetMapper()->AddClippingPlane(second);
  EXPECT_NE(scene.renderMask(), whole);
  const auto limit = 2 * rimPixels; // the cut's edge is computed in two ways
  EXPECT_LE(scene.compare().wrongCertain, limit);
  scene.ballActor->SetPosition(0.2, 0.1, 0.3);
  scene.ballActor->SetScale(1.0, 0.7, 1.2);
  scene.ballActor->RotateZ(30.0);
  EXPECT_LE(scene.compare().wrongCertain, limit);
  plane->SetOrigin(0.1, 0.9, 0.0);
  EXPECT_LE(scene.compare().wrongCertain, limit);
  scene.ballActor->GetMapper()->RemoveAllClippingPlanes();
  scene.ballActor->SetPosition(0.0, 0.0, 0.0);
  scene.ballActor->SetScale(1.0);
  scene.ballActor->SetOrientation(0.0, 0.0, 0.0);
  EXPECT_EQ(scene.renderMask(), whole);
}

TEST(PassHidden, CulledFaces_CastButAreNotSeen)
{
  for (const int front : {0, 1})
  {
    BallScene scene;
    scene.ball->SetStartTheta(100.0);
    scene.ballActor->GetProperty()->SetFrontfaceCulling(front);
    scene.ballActor->GetProperty()->SetBackfaceCulling(1 - front);
    EXPECT_EQ(scene.maskAt(BallScene::inShadow), 0) << front;
    EXPECT_LE(scene.compare().wrongCertain, rimPixels) << front;
    for (const int method : {vtkShadowVolumePass::STENCIL_ZPASS, vtkShadowVolumePass::STENCIL_ZFAIL})
    {
      scene.pass->SetStencilMethod(method);
      EXPECT_LE(scene.compare().wrongCertain, rimPixels) << front << ", " << method;
    }
  }
}

TEST(PassHidden, CulledFacesOfMirroredActor_MaskFitsThePicture)
{
  // VTK culls by the order of the corners on the screen, so that mirroring swaps front and back.
  for (const bool mirrored : {false, true})
  {
    for (const bool back : {true, false})
    {
      BallScene scene;
      scene.pass->SetCasting(scene.ballActor, false);
      scene.ballActor->SetScale(mirrored ? -1.0 : 1.0, 1.0, 1.0);
      scene.ballActor->GetProperty()->SetBackfaceCulling(back);
      scene.ballActor->GetProperty()->SetFrontfaceCulling(!back);
      // The side that the camera sees faces the lamp where the outside is shown.
      EXPECT_EQ(scene.maskAt(glm::dvec3(-0.2, 1.35, 0.2)), back != mirrored ? 255 : 0)
          << mirrored << ", " << back;
    }
  }
}

TEST(PassHidden, BothFacesCulled_AsVTKOnlyTheBack)
{
  BallScene scene;
  const Pixels mask = scene.renderMask();
  scene.ballActor->GetProperty()->BackfaceCullingOn();
  scene.ballActor->GetProperty()->FrontfaceCullingOn();
  EXPECT_EQ(scene.renderMask(), mask);
}

TEST(PassHidden, InvisibleBlock_NeitherSeenNorCasts)
{
  BallScene scene;
  scene.renderer->RemoveActor(scene.ballActor);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, ballAt(0.0, 1.0, 0.0));
  blocks->SetBlock(1, ballAt(-0.9, 1.2, 0.4));
  blocks->SetBlock(2, nullptr);
  vtkNew<shadow::truth::CompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene.renderer->AddActor(actor);
  const Pixels both = scene.renderMask();
  EXPECT_EQ(scene.maskAt(BallScene::inShadow), 0);
  EXPECT_LE(scene.compare().wrongCertain, rimPixels);
  attributes->SetBlockVisibility(blocks->GetBlock(0), false);
  mapper->Modified();
  EXPECT_EQ(scene.maskAt(BallScene::inShadow), 255);
  EXPECT_LE(scene.compare().wrongCertain, rimPixels);
  attributes->SetBlockVisibility(blocks->GetBlock(0), true);
  mapper->Modified();
  EXPECT_EQ(scene.renderMask(), both);
}

TEST(PassHidden, CasterOutsideTheView_StillShadows)
{
  BallScene scene;
  scene.renderer->GetActiveCamera()->SetFocalPoint(0.5, -0.1, 0.0);
  scene.renderer->GetActiveCamera()->SetViewAngle(7.0);
  scene.renderer->GetActiveCamera()->SetPosition(1.5, 0.6, 6.0);
  EXPECT_EQ(scene.compare().wrongCertain, 0u);
  EXPECT_GT(countValue(scene.renderMask(), 0), 400u);
}

TEST(PassReport, UnlitSurfaces_SaidInOneLine)
{
  BallScene scene;
  const auto messages = MessageCounter::observe(scene.pass);
  scene.renderMask();
  EXPECT_EQ(scene.pass->GetStatusMessage(), "");
  scene.table->GetProperty()->LightingOff();
  scene.renderMask();
  EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_OK) << "it may be meant to be so";
  EXPECT_EQ(scene.pass->GetStatusMessage(), "no shadow shows on vtkOpenGLActor in prop 1: lighting is off");
  EXPECT_EQ(messages->warnings, 0);
  vtkActor* more = scene.addMapper(scene.table->GetMapper());
  more->GetProperty()->LightingOff();
  scene.renderMask();
  EXPECT_EQ(scene.pass->GetStatusMessage(),
            "no shadow shows on vtkOpenGLActor in prop 1 and 1 more: lighting is off");
  scene.ballActor->GetProperty()->LightingOff();
  scene.renderMask();
  EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_PARTIAL);
  EXPECT_EQ(scene.pass->GetStatusMessage(), "no shadow shows on any surface: the lighting of all is off");
  EXPECT_EQ(messages->warnings, 1);
  scene.table->GetProperty()->LightingOn();
  more->GetProperty()->LightingOn();
  scene.ballActor->GetProperty()->LightingOn();
  scene.renderMask();
  EXPECT_EQ(scene.pass->GetStatusMessage(), "");
}
