// The paper's technique: its options leave the picture as it is, and faces of any shape have the lines that
// rectangles have.

#include <algorithm>

#include <gtest/gtest.h>

#include <vtkCamera.h>

#include "BallScene.h"
#include "OutlineCase.h"

using namespace shadow::test;
using shadow::TriangleSoup;
using shadow::truth::OutlineScene;

namespace
{

constexpr double widths[] = {1.0, 2.0, 4.0, 8.0, 32.0};

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
    const Pixels plain = scene.renderLines(width);
    EXPECT_GT(countValue(plain, 255), 100u);
    for (int options = 1; options < 4; ++options)
    {
      scene.outlines->SetSplitLargeFaces(options % 2 == 1);
      scene.outlines->SetLeaveOutFlatFaces(options / 2 == 1);
      EXPECT_EQ(countDifferent(scene.renderLines(width), plain), 0u) << width << ", options " << options;
    }
    triangles = std::max(triangles, scene.outlines->GetLineTriangles());
  }
  return triangles;
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

/// A roof of two slopes over a ridge with corners in its middle on one side only: a face without area closes
/// the gap. @param ends  triangles on the ridge's other side; the last may be missing, which is a border
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
  setCamera(scene, {1.2, 1.6, 3.2}, {0.0, 0.0, 0.0});
  const vtkIdType faces = 12 + 2 * 48 * 24;
  EXPECT_GT(expectOptionsSame(scene), faces) << "none of the cube's is split";
  EXPECT_GT(expectOptionsSame(scene, true), faces);
  scene.renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.renderer->GetActiveCamera()->SetParallelScale(1.5);
  EXPECT_GT(expectOptionsSame(scene), faces);
}

TEST(OutlineFaces, LargeTriangleAlone_AllItsBordersSplitOrNot)
{
  OutlineScene scene(320, 240);
  TriangleSoup triangle;
  triangle.points = {{-1.0, -0.8, 0.0}, {1.0, -0.7, 0.2}, {0.1, 0.9, 0.1}};
  triangle.triangles = {{0, 1, 2}};
  scene.addPolyData(toPolyData(triangle));
  setCamera(scene, {0.2, 0.1, 3.5}, {0.0, 0.0, 0.0});
  EXPECT_EQ(expectOptionsSame(scene), 4) << "not split";
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
  TriangleSoup plates;
  constexpr std::uint32_t columns = 33;
  for (std::uint32_t i = 0; i < columns * columns; ++i)
  {
    plates.points.emplace_back(i % columns / 16.0, static_cast<double>(i / columns) / 16.0, 0.0);
  }
  for (std::uint32_t i = 0; i + columns + 1 < columns * columns; ++i)
  {
    if (i % columns + 1 < columns)
    {
      plates.triangles.push_back({i, i + 1, i + columns + 1});
      plates.triangles.push_back({i, i + columns + 1, i + columns});
    }
  }
  for (const double height : {0.0, 0.3, 0.6})
  {
    scene.addPolyData(toPolyData(plates))->SetPosition(0.1 * height, 0.0, height);
  }
  for (const double azimuth : {0.0, 60.0, 89.9})
  {
    setCamera(scene, {1.0, 1.0, 5.0}, {1.0, 1.0, 0.0});
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
