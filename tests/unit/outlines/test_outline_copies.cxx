// Sheets whose triangles are stored more than once: lines and pictures of the sheet stored once.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <vtkCamera.h>
#include <vtkPoints.h>
#include <vtkProperty.h>

#include "BallScene.h"
#include "OutlineCase.h"

using namespace shadow::test;
using shadow::truth::OutlineScene;

namespace
{

struct Sheet
{
  std::string name;
  shadow::TriangleSoup soup;
  std::size_t again; ///< how many triangles are stored again
};

std::vector<Sheet> makeSheets()
{
  const shadow::TriangleSoup square = makeFlatSquare(8);
  shadow::TriangleSoup half = makeSphere(1.0, 24, 12);
  half.triangles.resize(half.triangles.size() / 2);
  return {{"square", square, square.triangles.size()},
          {"quad", makeFlatSquare(1), 2},
          {"one triangle of a square", square, 1},
          {"half a sphere", half, half.triangles.size()},
          {"one triangle of a sphere", makeSphere(1.0, 24, 12), 1},
          {"sphere", makeSphere(1.0, 24, 12), 100000}};
}

shadow::TriangleSoup storeAgain(const Sheet& sheet, bool turned, int copies = 1)
{
  shadow::TriangleSoup soup = sheet.soup;
  shadow::TriangleSoup again = sheet.soup;
  again.triangles.erase(again.triangles.begin(),
                        again.triangles.end() -
                            static_cast<std::ptrdiff_t>(std::min(sheet.again, again.triangles.size())));
  if (turned)
  {
    turnInsideOut(again);
  }
  for (int copy = 0; copy < copies; ++copy)
  {
    append(soup, again);
  }
  return soup;
}

void addBehind(OutlineScene& scene)
{
  scene.addPolyData(toPolyData(makeSphere(1.2, 16, 8, {-0.4, -0.6, -1.5})));
}

/// Looks at a mesh from aslant, with something behind it.
void setUp(OutlineScene& scene, const shadow::TriangleSoup& soup)
{
  scene.addPolyData(toPolyData(soup));
  addBehind(scene);
  setCamera(scene, {1.0, 1.5, 4.0}, {0.0, 0.0, 0.0});
}

} // namespace

TEST(OutlineCopies, AnyWinding_LinesOfTheSheetStoredOnce)
{
  for (const Sheet& sheet : makeSheets())
  {
    OutlineScene once(200, 150);
    setUp(once, sheet.soup);
    for (const bool turned : {false, true})
    {
      for (const int copies : {1, 2})
      {
        OutlineScene again(200, 150);
        setUp(again, storeAgain(sheet, turned, copies));
        for (int technique = 0; technique < 2; ++technique)
        {
          once.outlines->SetTechnique(technique);
          again.outlines->SetTechnique(technique);
          for (const bool crease : {false, true})
          {
            once.outlines->SetCreaseEdges(crease);
            again.outlines->SetCreaseEdges(crease);
            const Pixels lines = once.renderLines(2.0);
            EXPECT_GT(countValue(lines, 255), 300u) << sheet.name;
            EXPECT_EQ(countDifferent(again.renderLines(2.0), lines), 0u)
                << sheet.name << ", turned " << turned << ", technique " << technique << ", crease "
                << crease;
            EXPECT_EQ(again.outlines->GetLineEdges(), once.outlines->GetLineEdges()) << sheet.name;
          }
        }
      }
    }
  }
}

TEST(OutlineCopies, SquareOfEightByEight_ItsRimOnly)
{
  OutlineScene scene(200, 150);
  scene.addPolyData(toPolyData(storeAgain(makeSheets()[0], true)));
  setCamera(scene, {1.0, 1.5, 4.0}, {0.0, 0.0, 0.0});
  scene.renderLines(2.0);
  EXPECT_EQ(scene.outlines->GetLineEdges(), 32);
  expectRight(scene);
}

TEST(OutlineCopies, BacksOrFrontsCulled_FrontAndBackStillHide)
{
  const Sheet square = makeSheets()[0];
  for (const double z : {4.0, -4.0})
  {
    OutlineScene once(200, 150);
    setUp(once, square.soup);
    setCamera(once, {1.0, 1.5, z}, {0.0, 0.0, 0.0});
    OutlineScene again(200, 150);
    vtkActor* actor = again.addPolyData(toPolyData(storeAgain(square, true)));
    addBehind(again);
    setCamera(again, {1.0, 1.5, z}, {0.0, 0.0, 0.0});
    for (int technique = 0; technique < 2; ++technique)
    {
      once.outlines->SetTechnique(technique);
      again.outlines->SetTechnique(technique);
      const Pixels lines = once.renderLines(2.0);
      for (const bool backs : {true, false})
      {
        actor->GetProperty()->SetBackfaceCulling(backs);
        actor->GetProperty()->SetFrontfaceCulling(!backs);
        EXPECT_EQ(countDifferent(again.renderLines(2.0), lines), 0u) << "backs " << backs << ", z " << z;
      }
    }
  }
}

TEST(OutlineCopies, HiddenLinesAndPicture_OfTheSheetStoredOnce)
{
  const Sheet square = makeSheets()[0];
  OutlineScene once(200, 150);
  setUp(once, square.soup);
  OutlineScene again(200, 150);
  setUp(again, storeAgain(square, false));
  for (OutlineScene* scene : {&once, &again})
  {
    scene->outlines->HiddenEdgesOn();
    scene->renderer->SetPass(scene->outlines);
  }
  EXPECT_EQ(countDifferent(again.renderPicture(), once.renderPicture()), 0u);
}

TEST(OutlineCopies, SheetBends_LinesOfTheBentSheetStoredOnce)
{
  const Sheet square = makeSheets()[0];
  OutlineScene once(200, 150);
  OutlineScene again(200, 150);
  const auto single = toPolyData(square.soup);
  const auto doubled = toPolyData(storeAgain(square, true));
  once.addPolyData(single);
  again.addPolyData(doubled);
  setCamera(once, {1.0, -2.0, 4.0}, {0.0, 0.0, 0.0});
  setCamera(again, {1.0, -2.0, 4.0}, {0.0, 0.0, 0.0});
  for (int frame = 0; frame < 4; ++frame)
  {
    for (vtkPolyData* data : {single.Get(), doubled.Get()})
    {
      for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
      {
        double at[3];
        data->GetPoint(point, at);
        data->GetPoints()->SetPoint(point, at[0], at[1], -0.3 * frame * at[1] * at[1]);
      }
      data->GetPoints()->Modified();
    }
    for (int technique = 0; technique < 2; ++technique)
    {
      once.outlines->SetTechnique(technique);
      again.outlines->SetTechnique(technique);
      EXPECT_EQ(countDifferent(again.renderLines(2.0), once.renderLines(2.0)), 0u) << "frame " << frame;
    }
  }
}
