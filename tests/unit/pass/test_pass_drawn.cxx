// What casts and receives is what VTK draws: backdrops, shaders that move vertices, fans under clipping
// planes, lines and points beside polygons.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <vtkAppendPolyData.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCompositePolyDataMapper.h>
#include <vtkCubeSource.h>
#include <vtkImageActor.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPlane.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkSkybox.h>
#include <vtkTexture.h>

#include "BallScene.h"

using namespace shadow::test;

namespace
{

vtkSmartPointer<vtkTexture> makeSky()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 24, static_cast<unsigned char>(90));
  const auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  return texture;
}

/// A star of one concave polygon, or one quadrilateral that is not flat, above the table.
vtkSmartPointer<vtkPolyData> makePolygon(bool concave)
{
  vtkNew<vtkPoints> points;
  const int corners = concave ? 10 : 4;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * 3.14159265358979 * i / corners;
    const double radius = concave && i % 2 != 0 ? 0.25 : 0.8;
    const double height = concave || i % 2 == 0 ? 1.0 : 1.6;
    points->InsertNextPoint(radius * std::cos(angle), height, radius * std::sin(angle));
  }
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell(corners);
  for (int i = 0; i < corners; ++i)
  {
    polygons->InsertCellPoint(i);
  }
  const auto polygon = vtkSmartPointer<vtkPolyData>::New();
  polygon->SetPoints(points);
  polygon->SetPolys(polygons);
  return polygon;
}

/// A line across the view, in front of the ball's shadow, and points above its ends.
vtkSmartPointer<vtkPolyData> makeLine()
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> vertices;
  lines->InsertNextCell(2);
  for (const double x : {-1.0, 1.5})
  {
    lines->InsertCellPoint(points->InsertNextPoint(x, 0.6, 0.8));
  }
  for (const double x : {0.2, 0.6, 1.0})
  {
    vertices->InsertNextCell({points->InsertNextPoint(x, 0.3, 0.6)});
  }
  const auto line = vtkSmartPointer<vtkPolyData>::New();
  line->SetPoints(points);
  line->SetLines(lines);
  line->SetVerts(vertices);
  return line;
}

std::string skipped(vtkShadowVolumePass* pass)
{
  std::string all;
  for (int i = 0; i < pass->GetNumberOfSkippedCasters(); ++i)
  {
    all += pass->GetSkippedCaster(i) + "\n";
  }
  return all;
}

Pixels renderMask(BallScene& scene)
{
  scene.window->Render();
  return readMask(scene.pass, 0);
}

} // namespace

TEST(PassDrawn, Skybox_NeitherCastsNorIsReported)
{
  BallScene scene;
  const Pixels without = renderMask(scene);
  vtkNew<vtkSkybox> sky;
  sky->SetTexture(makeSky());
  sky->SetProjectionToSphere();
  scene.renderer->AddActor(sky);
  EXPECT_GT(countValue(without, 0), 100u);
  EXPECT_EQ(countDifferent(renderMask(scene), without), 0u);
  EXPECT_EQ(skipped(scene.pass).find("Skybox"), std::string::npos) << skipped(scene.pass);
  EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_OK) << scene.pass->GetStatusMessage();
}

TEST(PassDrawn, PlaneThatCutsNothingAway_SameShadowOfAnyPolygon)
{
  for (const bool concave : {true, false})
  {
    BallScene scene;
    scene.ballActor->VisibilityOff();
    vtkActor* actor = scene.addPolyData(makePolygon(concave));
    const Pixels whole = renderMask(scene);
    EXPECT_GT(countValue(whole, 0), 100u);
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(-5.0, 0.0, 0.0);
    plane->SetNormal(1.0, 0.0, 0.0);
    actor->GetMapper()->AddClippingPlane(plane);
    EXPECT_EQ(countDifferent(renderMask(scene), whole), 0u) << (concave ? "concave" : "not flat");
    plane->SetOrigin(0.1, 0.0, 0.0);
    EXPECT_GT(countDifferent(renderMask(scene), whole), 20u);
    EXPECT_LE(scene.compare().wrongCertain, rimPixels);
  }
}

TEST(PassDrawn, ShaderThatMovesVertices_SkippedWithReason)
{
  const std::string moves = "vec4 moved = vertexMC + vec4(0.0, 0.5, 0.0, 0.0);\n"
                            "vertexVCVSOutput = MCVCMatrix * moved; gl_Position = MCDCMatrix * moved;\n";
  BallScene scene;
  scene.ballActor->GetShaderProperty()->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true, moves,
                                                                   false);
  EXPECT_EQ(scene.maskAt(BallScene::inShadow), 255) << "the shadow of a ball that is not there";
  EXPECT_NE(skipped(scene.pass).find("move its vertices"), std::string::npos) << skipped(scene.pass);
  scene.ballActor->GetShaderProperty()->ClearAllVertexShaderReplacements();
  EXPECT_EQ(scene.maskAt(BallScene::inShadow), 0);
}

TEST(PassDrawn, ShaderThatOnlyReadsPositions_Casts)
{
  BallScene scene;
  vtkShaderProperty* shaders = scene.ballActor->GetShaderProperty();
  const std::string declaration = "//VTK::Normal::Dec\nout vec4 mine;\n";
  const std::string reading = "//VTK::Normal::Impl\nmine = vertexMC; if (gl_Position == mine) {}\n";
  shaders->AddVertexShaderReplacement("//VTK::Normal::Dec", true, declaration, false);
  shaders->AddVertexShaderReplacement("//VTK::Normal::Impl", true, reading, false);
  EXPECT_EQ(scene.maskAt(BallScene::inShadow), 0) << skipped(scene.pass);
}

TEST(PassDrawn, LinesBesidePolygons_AsInActorsOfTheirOwn)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(-1.2, -0.9, 0.1, 0.5, 0.5, 0.9);
  cube->Update();
  vtkNew<vtkPolyData> polygons;
  polygons->CopyStructure(cube->GetOutput());
  const auto line = makeLine();
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(polygons);
  both->AddInputData(line);
  both->Update();
  for (const bool tubes : {true, false})
  {
    Pixels pictures[2];
    for (const bool mixed : {false, true})
    {
      BallScene scene;
      std::vector<vtkActor*> actors{scene.addPolyData(mixed ? both->GetOutput() : polygons.GetPointer())};
      if (!mixed)
      {
        actors.push_back(scene.addPolyData(line));
      }
      for (vtkActor* actor : actors)
      {
        actor->GetProperty()->SetRenderLinesAsTubes(tubes);
        actor->GetProperty()->SetRenderPointsAsSpheres(tubes);
        actor->GetProperty()->SetLineWidth(9.0f);
        actor->GetProperty()->SetPointSize(15.0f);
      }
      pictures[mixed ? 1 : 0] = scene.renderPicture();
    }
    EXPECT_EQ(countDifferent(pictures[0], pictures[1], 1), 0u) << (tubes ? "tubes" : "lines");
  }
}

TEST(PassDrawn, TubesAndSpheres_AreSkippedWithAReason)
{
  for (const bool tubes : {true, false})
  {
    BallScene scene;
    vtkProperty* property = scene.addPolyData(makeLine())->GetProperty();
    property->SetRenderLinesAsTubes(tubes);
    property->SetRenderPointsAsSpheres(tubes);
    property->SetLineWidth(9.0f);
    scene.window->Render();
    EXPECT_EQ(skipped(scene.pass).find("drawn as tubes") != std::string::npos, tubes) << skipped(scene.pass);
    EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_OK);
  }
}

TEST(PassDrawn, CompositeMapper_CastsAsItsBlocks)
{
  BallScene scene;
  const Pixels own = renderMask(scene);
  scene.ball->Update();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, scene.ball->GetOutput());
  vtkNew<vtkCompositePolyDataMapper> mapper;
  mapper->SetInputDataObject(blocks);
  scene.ballActor->SetMapper(mapper);
  EXPECT_EQ(countDifferent(renderMask(scene), own), 0u) << skipped(scene.pass);
}

TEST(PassDrawn, ImageActor_StatusSaysItHasNoShadow)
{
  BallScene scene;
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 48, static_cast<unsigned char>(90));
  vtkNew<vtkImageActor> actor;
  actor->SetInputData(image);
  scene.renderer->AddViewProp(actor);
  const auto messages = MessageCounter::observe(scene.pass);
  scene.window->Render();
  EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_PARTIAL);
  EXPECT_NE(std::string(scene.pass->GetStatusMessage()).find("vtkImageActor"), std::string::npos);
  EXPECT_EQ(messages->warnings, 1);
}

TEST(PassDrawn, ViewportWithoutWidth_NothingAndNoError)
{
  BallScene scene;
  scene.window->Render();
  scene.renderer->SetViewport(0.5, 0.0, 0.5, 1.0);
  const auto messages = MessageCounter::observe(scene.pass);
  scene.window->Render();
  EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_OK) << scene.pass->GetStatusMessage();
  EXPECT_EQ(messages->warnings + messages->errors, 0) << messages->last;
}

TEST(PassDrawn, EdgesOfHiddenBacks_AsVtkDrawsThem)
{
  BallScene scene;
  scene.ball->SetThetaResolution(200);
  scene.ball->SetPhiResolution(100);
  scene.pass->SetShadowIntensity(0.0);
  scene.renderPicture();
  scene.lamp->SetPosition(-2.0, 4.0, 0.5);
  scene.renderPicture();
  scene.expectHiddenBacks(1);
  scene.ballActor->GetProperty()->EdgeVisibilityOn();
  scene.renderPicture();
  scene.lamp->SetPosition(-2.1, 4.0, 0.5);
  const Pixels ours = scene.renderPicture();
  EXPECT_EQ(scene.pass->GetNumberOfHiddenBacks(), 0);
  attachPlainSteps(scene.renderer);
  EXPECT_EQ(countDifferent(ours, scene.renderPicture()), 0u);
}

TEST(PassDrawn, CameraBeyondSinglePrecision_StatusSaysSo)
{
  for (const bool parallel : {false, true})
  {
    BallScene scene;
    vtkCamera* camera = scene.renderer->GetActiveCamera();
    if (parallel)
    {
      camera->ParallelProjectionOn();
      camera->SetParallelScale(1e300);
    }
    else
    {
      camera->SetPosition(1e300, 1e300, 0.0);
    }
    const auto messages = MessageCounter::observe(scene.pass);
    scene.window->Render();
    EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_NOT_SUPPORTED) << parallel;
    EXPECT_NE(std::string(scene.pass->GetStatusMessage()).find("camera"), std::string::npos);
    EXPECT_EQ(messages->warnings + messages->errors, 1);
  }
}

TEST(PassDrawn, ActorScaledBeyondAllBounds_StatusSaysSo)
{
  BallScene scene;
  scene.ballActor->SetScale(1e300);
  const auto messages = MessageCounter::observe(scene.pass);
  scene.window->Render();
  EXPECT_NE(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_OK);
  EXPECT_NE(std::string(scene.pass->GetStatusMessage()).find("transform"), std::string::npos);
  EXPECT_EQ(messages->warnings + messages->errors, 1);
}
