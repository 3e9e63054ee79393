// How many triangles and volumes there are, and that the ways to put light and shadow together agree.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include <vtkCamera.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include "BallScene.h"

using namespace shadow::test;

namespace
{

/// A ball without a table under some lamps, drawn by Additive.
void makeLoneBall(BallScene& scene, int lights)
{
  scene.renderer->RemoveActor(scene.table);
  scene.pass->SetCompositingToAdditive();
  for (int i = 1; i < lights; ++i)
  {
    scene.addPointLight(2.0 - i, 3.0, 1.0 + i);
  }
}

/// Whether a value of an image differs within @p reach pixels.
bool variesAround(const Pixels& image, int width, int height, int x, int y, int reach)
{
  const unsigned char here = image[static_cast<std::size_t>(y * width + x)];
  for (int j = std::max(0, y - reach); j <= std::min(height - 1, y + reach); ++j)
  {
    for (int i = std::max(0, x - reach); i <= std::min(width - 1, x + reach); ++i)
    {
      if (image[static_cast<std::size_t>(j * width + i)] != here)
      {
        return true;
      }
    }
  }
  return false;
}

} // namespace

TEST(PassTotals, AdditiveZPass_ThesisTotal)
{
  for (const int lights : {1, 2, 3})
  {
    BallScene scene;
    makeLoneBall(scene, lights);
    scene.pass->SetStencilMethodToZPass();
    scene.window->Render();
    const vtkIdType t = scene.ball->GetOutput()->GetNumberOfPolys();
    const vtkIdType sides = scene.pass->GetSideTriangles();
    ASSERT_EQ(scene.pass->GetNumberOfShadowLights(), lights);
    EXPECT_GT(sides, 0);
    EXPECT_EQ(sides % 2, 0);
    // t + (t + k) lights, where k lights is the sum over the lights.
    EXPECT_EQ(scene.pass->GetTotalTriangles(), t + t * lights + sides) << lights;
    EXPECT_EQ(scene.pass->GetCapTriangles(), 0);
    EXPECT_EQ(scene.pass->GetSilhouetteEdges() * 2, sides);
  }
}

TEST(PassTotals, AdditiveZFail_ThesisTotal)
{
  for (const int lights : {1, 2, 3})
  {
    BallScene scene;
    makeLoneBall(scene, lights);
    scene.pass->SetStencilMethodToZFail();
    scene.window->Render();
    const vtkIdType t = scene.ball->GetOutput()->GetNumberOfPolys();
    const vtkIdType sides = scene.pass->GetSideTriangles();
    EXPECT_GT(sides, 0);
    // t + (2 t + k) lights
    EXPECT_EQ(scene.pass->GetTotalTriangles(), t + 2 * t * lights + sides) << lights;
    EXPECT_EQ(scene.pass->GetNumberOfZFailCasters(), lights);
  }
}

TEST(PassTotals, Mask_OneOpaquePassAndNoLightingPasses)
{
  BallScene scene;
  scene.addPointLight(1.5, 4.0, 0.0);
  scene.window->Render();
  EXPECT_EQ(scene.pass->GetLightingTriangles(), 0);
  const vtkIdType t = scene.ball->GetOutput()->GetNumberOfPolys() + 2;
  EXPECT_EQ(scene.pass->GetAmbientTriangles(), t);
  EXPECT_EQ(scene.pass->GetPrePassTriangles(), t);
  EXPECT_EQ(scene.pass->GetTotalTriangles(),
            t + scene.pass->GetSideTriangles() + scene.pass->GetCapTriangles());
}

TEST(PassTotals, SixActorsShareOneDataSetUnderThreeLights_18Volumes)
{
  const auto memory = [](bool shared)
  {
    BallScene scene;
    scene.ball->SetThetaResolution(60);
    scene.ball->SetPhiResolution(60);
    scene.ball->SetRadius(0.3);
    scene.addPointLight(1.5, 4.0, 0.5);
    scene.addPointLight(0.0, 4.0, 1.5);
    scene.ball->Update();
    for (int i = 1; i < 6; ++i)
    {
      vtkNew<vtkPolyData> copy;
      copy->DeepCopy(scene.ball->GetOutput());
      vtkActor* actor = shared ? scene.addSource(scene.ball) : scene.addPolyData(copy);
      actor->SetPosition(0.5 * i - 1.6, 0.2 * (i % 2), 0.4 - 0.3 * (i % 3));
    }
    scene.window->Render();
    EXPECT_EQ(scene.pass->GetNumberOfRebuiltVolumes(), 18);
    EXPECT_EQ(scene.pass->GetNumberOfCasters(), 18);
    EXPECT_LE(scene.compare(2).wrongCertain, 2 * rimPixels);
    return scene.pass->GetMemorySize();
  };
  EXPECT_LT(memory(true), 0.7 * memory(false)) << "the adjacency is not shared";
}

TEST(PassTotals, StagesAreTimed)
{
  BallScene scene;
  scene.pass->MeasureStagesOn();
  scene.window->Render();
  EXPECT_GT(scene.pass->GetSceneMilliseconds(), 0.0);
  EXPECT_GT(scene.pass->GetSilhouetteMilliseconds(), 0.0);
  EXPECT_GT(scene.pass->GetPrePassMilliseconds(), 0.0);
  EXPECT_GT(scene.pass->GetStencilMilliseconds(), 0.0);
  EXPECT_GT(scene.pass->GetLightingMilliseconds(), 0.0);
}

TEST(PassCompositing, Additive_SameAsMaskWithinRounding)
{
  for (const int lights : {1, 2, 4})
  {
    BallScene scene;
    scene.table->GetProperty()->SetColor(0.9, 0.6, 0.3);
    scene.ballActor->GetProperty()->SetSpecular(0.3);
    scene.lamp->SetIntensity(1.0 / lights);
    for (int i = 1; i < lights; ++i)
    {
      vtkLight* light = scene.addPointLight(1.5 - i, 4.0, i - 1.0);
      light->SetColor(1.0, 0.3 * i, 0.5);
      light->SetIntensity(1.0 / lights);
    }
    scene.pass->SetCompositingToMask();
    const Pixels mask = scene.renderPicture();
    scene.pass->SetCompositingToAdditive();
    EXPECT_EQ(countDifferent(scene.renderPicture(), mask, lights + 1), 0u) << lights;
  }
}

TEST(PassSamples, Four_ShadowEdgesAreSmooth)
{
  BallScene scene;
  scene.pass->SetSamples(4);
  const Pixels mask = scene.renderMask();
  const std::set<unsigned char> values(mask.begin(), mask.end());
  EXPECT_GE(values.size(), 4u);
  const Pixels picture = scene.renderPicture();
  scene.pass->SetSamples(1);
  const Pixels hard = scene.renderMask();
  EXPECT_EQ(std::set<unsigned char>(hard.begin(), hard.end()).size(), 2u);
  EXPECT_GT(countDifferent(picture, scene.renderPicture(), 10), 50u);
}

TEST(PassSamples, Default_AsManyAsTheWindowHas)
{
  BallScene scene;
  EXPECT_EQ(scene.pass->GetSamples(), 0);
  const Pixels hard = scene.renderMask();
  EXPECT_EQ(std::set<unsigned char>(hard.begin(), hard.end()).size(), 2u);
  scene.window->SetMultiSamples(4);
  const Pixels smooth = scene.renderMask();
  EXPECT_GE(std::set<unsigned char>(smooth.begin(), smooth.end()).size(), 4u);
  scene.pass->SetSamples(1);
  EXPECT_EQ(scene.renderMask(), hard);
}

// Every pixel at the ball's edge is part ball, part table. The averted side of the ball is dark in the mask,
// the table is not.
TEST(PassSamples, MixedPixel_EachSurfaceTakesItsOwnShadow)
{
  BallScene scene;
  scene.window->SetMultiSamples(4);
  scene.pass->SetCasting(scene.ballActor, false);
  scene.pass->SetCasting(scene.table, false);
  scene.ballActor->GetProperty()->SetInterpolationToFlat();
  for (const bool aside : {false, true})
  {
    scene.lamp->SetPosition(aside ? -4.0 : 0.0, aside ? 0.5 : 3.0, aside ? -1.0 : 6.0);
    const Pixels picture = scene.renderPicture();
    scene.renderer->SetPass(nullptr);
    EXPECT_EQ(countDifferent(picture, scene.renderPicture()), 0u) << aside;
    scene.renderer->SetPass(scene.pass);
  }
}

TEST(PassSamples, Four_AwayFromShadowEdgesAsOne)
{
  BallScene scene;
  const Pixels mask = scene.renderMask();
  const Pixels one = scene.renderPicture();
  scene.pass->SetSamples(4);
  const Pixels four = scene.renderPicture();
  int different = 0;
  int compared = 0;
  for (int y = 0; y < 150; ++y)
  {
    for (int x = 0; x < 200; ++x)
    {
      const auto first = static_cast<std::size_t>(3 * (y * 200 + x));
      if (!variesAround(mask, 200, 150, x, y, 1))
      {
        ++compared;
        different += std::abs(one[first] - four[first]) > 1 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(compared, 25000);
  EXPECT_EQ(different, 0);
}

TEST(PassSamples, Four_NoHalosWhereTheMaskChangesAtGeometryEdges)
{
  // Nothing casts: the mask changes at the ball's rim, between its averted side and the table, and that must
  // not be seen on the table. The ball is red and the table green, so that each pixel tells what it shows.
  BallScene scene;
  scene.pass->SetCasting(scene.ballActor, false);
  scene.ballActor->GetProperty()->SetColor(1.0, 0.0, 0.0);
  scene.table->GetProperty()->SetColor(0.0, 1.0, 0.0);
  scene.renderer->SetBackground(0.0, 0.0, 1.0);
  const Pixels mask = scene.renderMask();
  const Pixels one = scene.renderPicture();
  scene.pass->SetSamples(4);
  const Pixels four = scene.renderPicture();
  int different = 0;
  int atRim = 0;
  for (int y = 0; y < 150; ++y)
  {
    for (int x = 0; x < 200; ++x)
    {
      const auto first = static_cast<std::size_t>(3 * (y * 200 + x));
      if (one[first] == 0)
      {
        different +=
            std::abs(one[first + 1] - four[first + 1]) > 1 || one[first + 2] != four[first + 2] ? 1 : 0;
        atRim += variesAround(mask, 200, 150, x, y, 1) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(atRim, 20);
  EXPECT_EQ(different, 0);
}
