// Outlines in windows of any shape, viewports, several renderers and windows, and with data that cannot be
// used.

#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkPlaneSource.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkTexture.h>

#include "OutlineBall.h"

using namespace shadow::test;

TEST(OutlineWindow, Resized_SameAsNewWindow)
{
  OutlineBall scene;
  scene.renderLines();
  for (const auto& [width, height] :
       {std::pair<int, int>{300, 100}, {80, 220}, {200, 150}, {640, 480}, {1, 1}, {64, 64}})
  {
    scene.window->SetSize(width, height);
    OutlineBall fresh(width, height);
    const Pixels lines = scene.renderLines();
    EXPECT_EQ(lines.size(), static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    EXPECT_EQ(lines, fresh.renderLines()) << width << " x " << height;
  }
}

TEST(OutlineWindow, SubViewport_SameLinesAsInOwnWindow)
{
  OutlineBall own;
  OutlineBall part(400, 250);
  part.renderer->SetViewport(0.25, 0.2, 0.75, 0.8);
  for (const Use use : allUses)
  {
    attach(own.renderer, own.outlines, use);
    attach(part.renderer, part.outlines, use);
    EXPECT_EQ(part.renderLines(), own.renderLines()) << toString(use);
    const Pixels picture = part.renderPicture();
    const Pixels ownPicture = own.renderPicture();
    std::size_t different = 0;
    for (std::size_t y = 0; y < 150; ++y)
    {
      for (std::size_t i = 0; i < 600; ++i)
      {
        different += std::abs(picture[1200 * (y + 50) + 300 + i] - ownPicture[600 * y + i]) > 2 ? 1 : 0;
      }
    }
    EXPECT_LE(different, 12u) << toString(use);
  }
}

TEST(OutlineWindow, LinesGoOnAtTheEdgeOfTheView)
{
  // What lies outside a small view is drawn as in a large one: half a line reaches into it, and its
  // visibility is known.
  OutlineBall large(600, 450);
  large.outlines->SetLineWidth(12.0);
  large.renderer->GetActiveCamera()->SetViewAngle(20.0);
  const Pixels whole = large.renderLines();
  OutlineBall small(200, 150);
  small.outlines->SetLineWidth(12.0);
  vtkCamera* camera = small.renderer->GetActiveCamera();
  const double tangent = std::tan(10.0 * 3.14159265358979323846 / 180.0);
  camera->SetViewAngle(2.0 * std::atan(tangent / 3.0) * 180.0 / 3.14159265358979323846);
  const Pixels middle = small.renderLines();
  std::size_t different = 0;
  for (std::size_t y = 0; y < 150; ++y)
  {
    for (std::size_t x = 0; x < 200; ++x)
    {
      different += middle[200 * y + x] != whole[600 * (y + 150) + x + 200] ? 1 : 0;
    }
  }
  EXPECT_GT(countValue(middle, 255), 200u);
  EXPECT_LE(different, 3u);
}

TEST(OutlineWindow, SeveralRenderers_SharedPassOrOwn_EachHasItsLines)
{
  for (const bool shared : {true, false})
  {
    OutlineBall scene(400, 150);
    vtkNew<vtkRenderer> second;
    second->AutomaticLightCreationOff();
    second->AddActor(scene.ballActor);
    second->AddActor(scene.table);
    second->AddLight(scene.lamp);
    second->SetBackground(scene.renderer->GetBackground());
    second->GetActiveCamera()->DeepCopy(scene.renderer->GetActiveCamera());
    vtkNew<vtkSilhouettePass> other;
    second->SetPass(shared ? scene.outlines.Get() : other.Get());
    scene.window->AddRenderer(second);
    scene.renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
    second->SetViewport(0.5, 0.0, 1.0, 1.0);
    OutlineBall alone;
    const Pixels expected = alone.renderPicture();
    for (int frame = 0; frame < 3; ++frame)
    {
      const Pixels picture = scene.renderPicture();
      std::size_t different = 0;
      for (std::size_t y = 0; y < 150; ++y)
      {
        for (std::size_t i = 0; i < 600; ++i)
        {
          different += std::abs(picture[1200 * y + i] - expected[600 * y + i]) > 2 ? 1 : 0;
          different += std::abs(picture[1200 * y + i] - picture[1200 * y + 600 + i]) > 2 ? 1 : 0;
        }
      }
      EXPECT_LE(different, 24u) << shared << " in frame " << frame;
    }
  }
}

TEST(OutlineWindow, TwoWindowsInTurn_OnePass_LinesStay)
{
  OutlineBall first;
  OutlineBall second(160, 120);
  const Pixels firstLines = first.renderLines();
  const Pixels secondLines = second.renderLines();
  second.renderer->SetPass(first.outlines);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(first.renderLines(), firstLines);
    second.window->Render();
    EXPECT_EQ(readLines(first.outlines), secondLines);
  }
}

TEST(OutlineWindow, ReleasedAndWindowGone_RendersAgain)
{
  vtkNew<vtkSilhouettePass> pass;
  for (int i = 0; i < 3; ++i)
  {
    auto scene = std::make_unique<OutlineBall>();
    scene->renderer->SetPass(pass);
    scene->window->Render();
    const Pixels lines = readLines(pass);
    EXPECT_GT(countValue(lines, 255), fewestLinePixels);
    pass->ReleaseGraphicsResources(scene->window);
    const auto messages = MessageCounter::observe(pass);
    EXPECT_TRUE(readLines(pass).empty());
    EXPECT_EQ(messages->errors, 1);
    scene->window->Render();
    EXPECT_EQ(readLines(pass), lines);
    scene.reset();
    EXPECT_TRUE(readLines(pass).empty());
    EXPECT_EQ(messages->errors, 2);
    pass->RemoveObserver(messages);
    EXPECT_GE(pass->GetMemorySize(), 0);
    EXPECT_GE(pass->GetLineEdges(), 0);
  }
}

TEST(OutlineReport, BadData_DrawnWithoutAndToldOnce)
{
  OutlineBall scene;
  const auto messages = MessageCounter::observe(scene.outlines);
  EXPECT_EQ(scene.outlines->GetStatus(), vtkSilhouettePass::STATUS_NOT_RENDERED);
  const Pixels lines = scene.renderLines();
  EXPECT_EQ(scene.outlines->GetStatus(), vtkSilhouettePass::STATUS_OK);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.0);
  points->InsertNextPoint(0.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({0, 1, 2});
  vtkNew<vtkPolyData> broken;
  broken->SetPoints(points);
  broken->SetPolys(triangles);
  scene.addPolyData(broken);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(scene.renderLines(), lines);
  }
  EXPECT_EQ(scene.outlines->GetStatus(), vtkSilhouettePass::STATUS_PARTIAL);
  EXPECT_NE(scene.outlines->GetStatusMessage().find("has no outline"), std::string::npos);
  EXPECT_EQ(messages->warnings, 1);
  EXPECT_EQ(messages->errors, 0);
}

TEST(OutlineReport, OneOfTwoRenderersWithBadData_ToldOnce)
{
  OutlineBall scene;
  vtkNew<vtkRenderer> good;
  good->AddActor(scene.table);
  good->SetPass(scene.outlines);
  scene.window->AddRenderer(good);
  vtkNew<vtkSphereSource> source;
  source->Update();
  source->GetOutput()->GetPoints()->SetPoint(5, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  scene.addPolyData(source->GetOutput());
  const auto messages = MessageCounter::observe(scene.outlines);
  for (int frame = 0; frame < 5; ++frame)
  {
    scene.window->Render();
  }
  EXPECT_EQ(messages->warnings, 1) << messages->last;
  EXPECT_EQ(messages->errors, 0) << messages->last;
}

TEST(OutlineReport, TranslucentAndWireframe_SkippedWithReason)
{
  OutlineBall scene;
  scene.ballActor->GetProperty()->SetOpacity(0.5);
  scene.table->GetProperty()->SetRepresentationToWireframe();
  EXPECT_EQ(countValue(scene.renderLines(), 255), 0u);
  EXPECT_EQ(scene.outlines->GetNumberOfSkippedProps(), 2);
  EXPECT_NE(scene.outlines->GetSkippedProp(0).find("it is translucent"), std::string::npos);
  EXPECT_EQ(scene.outlines->GetSkippedProp(2), "");
  EXPECT_EQ(scene.outlines->GetStatus(), vtkSilhouettePass::STATUS_OK);
}

TEST(OutlineReport, NothingToDraw_EmptyMask)
{
  OutlineBall scene;
  scene.renderer->RemoveAllViewProps();
  EXPECT_EQ(countValue(scene.renderLines(), 0), 200u * 150u);
  vtkNew<vtkPolyData> empty;
  scene.addPolyData(empty);
  EXPECT_EQ(countValue(scene.renderLines(), 0), 200u * 150u);
  EXPECT_EQ(scene.outlines->GetStatus(), vtkSilhouettePass::STATUS_OK) << scene.outlines->GetStatusMessage();
}

TEST(OutlineReport, OwnDelegate_IsRefused)
{
  vtkNew<vtkSilhouettePass> pass;
  const auto messages = MessageCounter::observe(pass);
  pass->SetDelegatePass(pass);
  EXPECT_EQ(messages->errors, 1);
  EXPECT_EQ(pass->GetDelegatePass(), nullptr);
  EXPECT_FALSE(pass->GetLineMask(nullptr));
  EXPECT_EQ(messages->errors, 2);
}

// VTK leaves out what has no alpha, and takes the actor for opaque, if something has.
TEST(OutlineWindow, TextureWithHoles_HidesLinesAsWholeFaces)
{
  OutlineBall scene;
  const std::size_t lines = countValue(scene.renderLines(), 255);
  const auto texture = makeTextureOfHoles();
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-9.0, -9.0, 2.5);
  plane->SetPoint1(9.0, -9.0, 2.5);
  plane->SetPoint2(-9.0, 9.0, 2.5);
  scene.addSource(plane)->SetTexture(texture);
  EXPECT_GT(lines, fewestLinePixels);
  EXPECT_EQ(countValue(scene.renderLines(), 255), 0u);
  EXPECT_EQ(scene.outlines->GetStatus(), vtkSilhouettePass::STATUS_OK);
}
