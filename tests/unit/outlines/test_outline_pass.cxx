// vtkSilhouettePass in its uses: over any delegate, and with every setting.

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

#include <vtkAssembly.h>
#include <vtkCamera.h>
#include <vtkProperty.h>

#include "OutlineBall.h"

using namespace shadow::test;

namespace
{

/// Pixels of a picture that are as dark as lines are, where the mask says so, and where it does not.
struct Darkness
{
  std::size_t onLines = 0;
  std::size_t elsewhere = 0;
};

Darkness countDark(const Pixels& picture, const Pixels& mask)
{
  Darkness dark;
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    const bool isDark = picture[3 * i] + picture[3 * i + 1] + picture[3 * i + 2] < 6;
    (mask[i] == 255 ? dark.onLines : dark.elsewhere) += isDark ? 1 : 0;
  }
  return dark;
}

} // namespace

TEST(OutlinePass, ThreeUses_SameLinesOverVtksPicture)
{
  OutlineBall scene;
  scene.renderer->SetBackground(0.3, 0.4, 0.5);
  scene.outlines->SmoothOff();
  attachPlainSteps(scene.renderer);
  const Pixels plain = scene.renderPicture();
  Pixels lines;
  for (const Use use : allUses)
  {
    attach(scene.renderer, scene.outlines, use);
    const Pixels picture = scene.renderPicture();
    const Pixels mask = readLines(scene.outlines);
    EXPECT_GT(countValue(mask, 255), fewestLinePixels) << toString(use);
    EXPECT_EQ(countValue(mask, 255) + countValue(mask, 0), mask.size());
    EXPECT_TRUE(lines.empty() || lines == mask) << toString(use);
    lines = mask;
    EXPECT_EQ(countDark(picture, mask).onLines, countValue(mask, 255)) << toString(use);
    for (std::size_t i = 0; i < picture.size(); ++i)
    {
      ASSERT_TRUE(mask[i / 3] == 255 || std::abs(picture[i] - plain[i]) <= 1) << toString(use) << " at " << i;
    }
  }
}

TEST(OutlinePass, ShadowPassAsDelegate_ThreeUses_ShadowsAndLines)
{
  OutlineBall scene;
  scene.outlines->SetDelegatePass(scene.pass);
  for (const Use use : allUses)
  {
    attach(scene.renderer, scene.pass, use);
    const Pixels shadows = scene.renderPicture();
    attach(scene.renderer, scene.outlines, use);
    const Pixels both = scene.renderPicture();
    const Pixels mask = readLines(scene.outlines);
    EXPECT_GT(countValue(mask, 255), fewestLinePixels) << toString(use);
    std::size_t differentElsewhere = 0;
    for (std::size_t i = 0; i < both.size(); ++i)
    {
      // A soft edge reaches one pixel beyond the line.
      const std::size_t pixel = i / 3;
      const std::size_t x = pixel % 200;
      const std::size_t y = pixel / 200;
      bool nearLine = false;
      for (std::size_t row = y > 0 ? y - 1 : 0; row <= std::min<std::size_t>(y + 1, 149); ++row)
      {
        for (std::size_t column = x > 0 ? x - 1 : 0; column <= std::min<std::size_t>(x + 1, 199); ++column)
        {
          nearLine = nearLine || mask[200 * row + column] == 255;
        }
      }
      differentElsewhere += !nearLine && std::abs(both[i] - shadows[i]) > 1 ? 1 : 0;
    }
    EXPECT_EQ(differentElsewhere, 0u) << toString(use);
  }
}

TEST(OutlinePass, LinesOnly_NothingButLinesOnTheBackground)
{
  OutlineBall scene;
  scene.renderer->SetBackground(1.0, 1.0, 1.0);
  scene.outlines->LinesOnlyOn();
  scene.outlines->SmoothOff();
  scene.outlines->SetColor(1.0, 0.0, 0.0);
  const Pixels picture = scene.renderPicture();
  const Pixels mask = readLines(scene.outlines);
  EXPECT_GT(countValue(mask, 255), fewestLinePixels);
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    ASSERT_EQ(picture[3 * i], 255);
    ASSERT_EQ(picture[3 * i + 1], mask[i] == 255 ? 0 : 255) << i;
  }
}

TEST(OutlinePass, Smooth_IsBetweenAtEdgesAndDarkInTheMiddle)
{
  OutlineBall scene;
  scene.renderer->SetBackground(1.0, 1.0, 1.0);
  scene.outlines->LinesOnlyOn();
  scene.outlines->SetLineWidth(4.0);
  const Pixels picture = scene.renderPicture();
  const Pixels mask = readLines(scene.outlines);
  std::size_t between = 0;
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    const int grey = picture[3 * i];
    between += grey > 5 && grey < 250 ? 1 : 0;
    // Half covered is where the mask ends.
    wrong += mask[i] == 255 ? grey > 129 : grey < 126;
  }
  EXPECT_GT(between, 300u);
  EXPECT_EQ(wrong, 0u);
}

TEST(OutlinePass, HiddenEdges_ShowBelowTheOthers)
{
  OutlineBall scene;
  scene.renderer->SetBackground(1.0, 1.0, 1.0);
  scene.outlines->LinesOnlyOn();
  scene.outlines->SmoothOff();
  const Pixels visible = scene.renderPicture();
  const Pixels mask = readLines(scene.outlines);
  scene.outlines->HiddenEdgesOn();
  scene.outlines->SetHiddenColor(0.0, 0.0, 1.0);
  scene.outlines->SetHiddenOpacity(1.0);
  const Pixels all = scene.renderPicture();
  EXPECT_EQ(readLines(scene.outlines), mask);
  std::size_t hidden = 0;
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    const bool blue = all[3 * i] == 0 && all[3 * i + 2] == 255;
    hidden += blue ? 1 : 0;
    ASSERT_TRUE(blue || all[3 * i] == visible[3 * i]) << i;
    ASSERT_TRUE(!blue || mask[i] == 0) << i;
  }
  EXPECT_GT(hidden, 20u); // the table's edge behind the ball
}

TEST(OutlinePass, KindsOfEdges_EachAlone)
{
  OutlineBall scene;
  const Pixels all = scene.renderLines();
  scene.outlines->BorderEdgesOff();
  const Pixels silhouette = scene.renderLines();
  scene.outlines->BorderEdgesOn();
  scene.outlines->SilhouetteEdgesOff();
  const Pixels border = scene.renderLines();
  EXPECT_EQ(scene.outlines->GetLineEdges(), 4); // the table's
  Pixels both = silhouette;
  for (std::size_t i = 0; i < both.size(); ++i)
  {
    both[i] = std::max(both[i], border[i]);
  }
  EXPECT_EQ(both, all);
  scene.outlines->BorderEdgesOff();
  EXPECT_EQ(countValue(scene.renderLines(), 255), 0u);
  scene.outlines->CreaseEdgesOn();
  scene.outlines->SetFeatureAngle(5.0);
  EXPECT_GT(countValue(scene.renderLines(), 255), fewestLinePixels);
  scene.outlines->SetFeatureAngle(90.0);
  EXPECT_EQ(countValue(scene.renderLines(), 255), 0u);
}

TEST(OutlinePass, PropNotOutlined_HidesTheOthersAllTheSame)
{
  OutlineBall scene;
  const Pixels all = scene.renderLines();
  scene.outlines->SetOutlined(scene.ballActor, false);
  EXPECT_FALSE(scene.outlines->GetOutlined(scene.ballActor));
  const Pixels table = scene.renderLines();
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    ASSERT_LE(table[i], all[i]) << i;
  }
  EXPECT_EQ(scene.outlines->GetLineEdges(), 4);
  scene.ballActor->VisibilityOff();
  EXPECT_GT(countValue(scene.renderLines(), 255), countValue(table, 255) + 20);
  scene.ballActor->VisibilityOn();
  scene.outlines->SetOutlined(scene.ballActor, true);
  EXPECT_EQ(scene.renderLines(), all);
}

TEST(OutlinePass, AssemblyAndMovedActor_SameLinesAsInPlace)
{
  OutlineBall scene;
  const Pixels inPlace = scene.renderLines();
  const vtkSmartPointer<vtkActor> ball = scene.ballActor; // the renderer had the only reference
  scene.renderer->RemoveActor(ball);
  vtkNew<vtkAssembly> inner;
  vtkNew<vtkAssembly> outer;
  scene.ballActor->SetPosition(1.0, 0.0, 0.0);
  inner->AddPart(scene.ballActor);
  inner->SetPosition(0.0, 2.0, 0.0);
  outer->AddPart(inner);
  scene.renderer->AddActor(outer);
  EXPECT_NE(scene.renderLines(), inPlace);
  outer->SetPosition(-1.0, -2.0, 0.0);
  EXPECT_LE(countDifferent(scene.renderLines(), inPlace), 4u);
  scene.outlines->SetOutlined(outer, false);
  scene.renderLines();
  EXPECT_EQ(scene.outlines->GetLineEdges(), 4);
}

TEST(OutlinePass, CameraMoves_LinesFollow)
{
  OutlineBall scene;
  scene.renderLines();
  scene.renderer->GetActiveCamera()->Azimuth(25.0);
  const Pixels moved = scene.renderLines();
  OutlineBall fresh;
  fresh.renderer->GetActiveCamera()->Azimuth(25.0);
  EXPECT_EQ(moved, fresh.renderLines());
  scene.renderer->GetActiveCamera()->ParallelProjectionOn();
  fresh.renderer->GetActiveCamera()->ParallelProjectionOn();
  EXPECT_EQ(scene.renderLines(), fresh.renderLines());
  scene.ball->SetThetaResolution(24);
  fresh.ball->SetThetaResolution(24);
  EXPECT_EQ(scene.renderLines(), fresh.renderLines());
}

TEST(OutlinePass, TwoTechniques_SameLines)
{
  OutlineBall scene(400, 300);
  scene.ball->SetThetaResolution(48);
  scene.ball->SetPhiResolution(37);
  for (const double width : {1.0, 2.0, 8.0})
  {
    for (const int crease : {0, 1})
    {
      scene.outlines->SetLineWidth(width);
      scene.outlines->SetCreaseEdges(crease != 0);
      scene.outlines->SetFeatureAngle(5.2);
      scene.outlines->SetTechniqueToRectangles();
      const Pixels rectangles = scene.renderLines();
      scene.outlines->SetTechniqueToFaces();
      const Pixels faces = scene.renderLines();
      EXPECT_GE(scene.outlines->GetLineTriangles(), scene.outlines->GetDepthTriangles());
      EXPECT_GT(countValue(faces, 255), fewestLinePixels);
      EXPECT_LE(countDifferent(rectangles, faces), countValue(faces, 255) / 500) << width << ", " << crease;
    }
  }
}
