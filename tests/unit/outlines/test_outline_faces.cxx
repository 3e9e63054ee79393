// The paper's technique: its options leave the picture as it is, and faces of any shape have the lines that
// rectangles have.

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include <vtkCamera.h>

#include "BallScene.h"
#include "GLInspection.h"
#include "OutlineCase.h"

using namespace shadow::test;
using shadow::TriangleSoup;
using shadow::truth::OutlineScene;

namespace
{

constexpr double widths[] = {1.0, 2.0, 4.0, 8.0, 32.0};

/// The line mask, and for one of the widths the picture with soft and with hard lines.
std::vector<Pixels> renderAll(OutlineScene& scene, double width)
{
  std::vector<Pixels> all = {scene.renderLines(width)};
  if (width == widths[2])
  {
    scene.outlines->SmoothOff();
    all.push_back(scene.renderPicture());
    scene.outlines->SmoothOn();
    all.push_back(scene.renderPicture());
    EXPECT_GT(countDifferent(all[1], all[2]), 0u);
  }
  return all;
}

/// Every mix of the options draws the same pixels. @return the most line triangles with the options on
vtkIdType expectOptionsSame(OutlineScene& scene, bool hidden = false)
{
  vtkIdType triangles = 0;
  scene.outlines->SetTechniqueToFaces();
  scene.outlines->SetHiddenEdges(hidden);
  for (const double width : widths)
  {
    scene.outlines->SplitLargeFacesOff();
    scene.outlines->LeaveOutFlatFacesOff();
    const std::vector<Pixels> plain = renderAll(scene, width);
    EXPECT_GT(countValue(plain[0], 255), 100u);
    for (int options = 1; options < 4; ++options)
    {
      scene.outlines->SetSplitLargeFaces(options % 2 == 1);
      scene.outlines->SetLeaveOutFlatFaces(options / 2 == 1);
      EXPECT_TRUE(renderAll(scene, width) == plain) << width << ", options " << options;
    }
    triangles = std::max(triangles, scene.outlines->GetLineTriangles());
  }
  return triangles;
}

/// That large faces really are drawn in parts, and not whole as well: where lines of one meet, each of its
/// parts draws their common pixels once more, and nothing else is drawn twice.
void expectSplit(OutlineScene& scene)
{
  scene.outlines->SetTechniqueToFaces();
  scene.outlines->SetLineWidth(8.0);
  scene.outlines->SplitLargeFacesOff();
  const std::size_t lines = countValue(scene.renderLines(8.0), 255);
  const std::size_t whole = countFragments(scene.window);
  scene.outlines->SplitLargeFacesOn();
  const std::size_t split = countFragments(scene.window);
  EXPECT_GT(split, whole + 20);
  EXPECT_LT(split, whole + lines / 2);
}

/// Pixels that the two techniques draw differently, at most this many at any width.
void expectTechniquesAgree(OutlineScene& scene, std::size_t most = 0)
{
  for (const double width : widths)
  {
    scene.outlines->SetTechniqueToRectangles();
    const Pixels rectangles = scene.renderLines(width);
    scene.outlines->SetTechniqueToFaces();
    EXPECT_GT(countValue(rectangles, 255), 20u);
    EXPECT_LE(countDifferent(scene.renderLines(width), rectangles), most) << width;
  }
}

/// A roof of two slopes over a ridge with a corner in its middle on one side only: a face without area closes
/// the gap.
/// @param border  the side with the corner ends there: half of it is missing
TriangleSoup makeRoof(bool border)
{
  TriangleSoup soup;
  soup.points = {{-1, 0, 0.5}, {0.2, 0, 0.5}, {1, 0, 0.5}, {0, 1, 0}, {0, -1, 0}};
  soup.triangles = {{0, 2, 3}, {0, 1, 2}, {1, 0, 4}};
  if (!border)
  {
    soup.triangles.push_back({2, 1, 4});
  }
  return soup;
}

} // namespace

TEST(OutlineFaces, Options_SamePicture)
{
  OutlineScene scene(320, 240);
  scene.addPolyData(toPolyData(makeCube({0.0, 0.0, 0.0}, 2.0)));
  scene.addPolyData(toPolyData(makeTorus(2.5, 0.3, 48, 24)));
  // With creases each triangle of the cube has two lines.
  scene.outlines->CreaseEdgesOn();
  setCamera(scene, {-1.2, 1.6, 3.2}, {0.0, 0.0, 0.0});
  const vtkIdType faces = 12 + 2 * 48 * 24;
  EXPECT_GT(expectOptionsSame(scene), faces) << "none of the cube's may be split";
  expectSplit(scene);
  const Pixels without = scene.renderPicture();
  EXPECT_GT(expectOptionsSame(scene, true), faces);
  EXPECT_GT(countDifferent(scene.renderPicture(), without), 100u) << "no hidden lines";
  scene.renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.renderer->GetActiveCamera()->SetParallelScale(1.5);
  EXPECT_GT(expectOptionsSame(scene), faces);
  expectSplit(scene);
}

TEST(OutlineFaces, LargeTriangleAlone_AllItsBordersSplitOrNot)
{
  OutlineScene scene(320, 240);
  TriangleSoup triangle;
  triangle.points = {{-1.0, -0.8, 0.0}, {1.0, -0.7, 0.2}, {0.1, 0.9, 0.1}};
  triangle.triangles = {{0, 1, 2}};
  scene.addPolyData(toPolyData(triangle));
  setCamera(scene, {0.2, 0.1, 3.5}, {0.0, 0.0, 0.0});
  EXPECT_EQ(expectOptionsSame(scene), 4) << "not asked whether it is large";
  expectSplit(scene);
  expectTechniquesAgree(scene);
}

TEST(OutlineFaces, NearPlaneAndEyeCloseBy_OptionsSamePicture)
{
  OutlineScene scene(320, 240);
  scene.addPolyData(toPolyData(makeCube({0.0, 0.0, 0.0}, 2.0)));
  scene.addPolyData(toPolyData(makeTorus(2.5, 0.3, 48, 24)));
  setCamera(scene, {0.4, 0.6, 3.0}, {0.0, 0.0, 0.0}, 2.2);
  scene.renderer->GetActiveCamera()->SetViewAngle(80.0);
  expectOptionsSame(scene);
  setCamera(scene, {2.0, 0.9, 0.8}, {0.0, 0.0, 0.0}, 0.05);
  expectOptionsSame(scene);
}

TEST(OutlineFaces, FlatParts_LeftOut_SamePicture)
{
  // A stack of finely divided plates: all but their rims.
  OutlineScene scene(320, 240);
  const TriangleSoup plates = makeFlatSquare(32);
  for (const double height : {0.0, 0.3, 0.6})
  {
    scene.addPolyData(toPolyData(plates))->SetPosition(0.1 * height, 0.0, height);
  }
  for (const double azimuth : {0.0, 60.0, 89.9})
  {
    setCamera(scene, {0.0, 0.0, 5.0}, {0.0, 0.0, 0.0});
    scene.renderer->GetActiveCamera()->Azimuth(azimuth);
    scene.renderer->ResetCamera();
    scene.renderer->ResetCameraClippingRange();
    EXPECT_LE(expectOptionsSame(scene), 3 * 4 * 32);
    expectTechniquesAgree(scene);
  }
}

TEST(OutlineFaces, FacesWithoutArea_LinesOfRectanglesAndOfTheTruth)
{
  for (const bool border : {false, true})
  {
    for (const double height : {-2.0, 0.2, 2.0})
    {
      SCOPED_TRACE(border ? "border" : "closed");
      OutlineScene scene(200, 150);
      scene.addPolyData(toPolyData(makeRoof(border)));
      setCamera(scene, {0.5, -4.0, height}, {0.0, 0.0, 0.2});
      expectTechniquesAgree(scene);
      expectRight(scene);
    }
  }
}

TEST(OutlineFaces, SubPixelFaces_LinesOfRectangles)
{
  OutlineScene scene(200, 150);
  scene.addPolyData(toPolyData(makeSphere(1.0, 300, 151)));
  for (const double distance : {12.0, 60.0})
  {
    setCamera(scene, {1.0, 2.0, distance}, {0.0, 0.0, 0.0});
    expectTechniquesAgree(scene, 2);
  }
}

TEST(OutlineFaces, Needles_LinesOfRectanglesFromAnySide)
{
  OutlineScene scene(200, 150);
  TriangleSoup needles = makeSphere(1.0, 64, 13);
  for (glm::dvec3& point : needles.points)
  {
    point.x *= 0.01;
  }
  scene.addPolyData(toPolyData(needles));
  for (const glm::dvec3& eye :
       {glm::dvec3(1.0, 0.5, 4.0), glm::dvec3(4.0, 0.5, 1.0), glm::dvec3(0.1, 4.0, 1.0)})
  {
    setCamera(scene, eye, {0.0, 0.0, 0.0});
    expectTechniquesAgree(scene, 2);
    expectRight(scene, 0.97);
  }
}

TEST(OutlineFaces, TinyAndHugeMeshes_LinesOfRectanglesAndOfTheTruth)
{
  for (const double scale : {1e-11, 1.0, 1e11})
  {
    SCOPED_TRACE(scale);
    OutlineScene scene(200, 150);
    TriangleSoup ring = makeTorus(1.0, 0.4, 24, 12);
    for (glm::dvec3& point : ring.points)
    {
      point *= scale;
    }
    scene.addPolyData(toPolyData(ring));
    setCamera(scene, scale * glm::dvec3(1.0, 2.0, 3.5), {0.0, 0.0, 0.0});
    expectTechniquesAgree(scene);
    expectRight(scene);
  }
}
