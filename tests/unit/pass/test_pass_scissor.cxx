// Volumes are counted where surfaces are seen only: the same masks and pictures, to the bit, as counted in all of the view.

#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <vtkCamera.h>
#include <vtkSphereSource.h>

#include "NewPass.h"
#include "ShadowScene.h"

using namespace shadow::truth;

namespace
{

using Pass = vtkShadowVolumePass;
constexpr int viewPixels = 160 * 120;

/// Two balls, one in the other's shadow, with nothing behind them.
struct BallsInSpace : ShadowScene
{
  BallsInSpace() : ShadowScene(160, 120)
  {
    for (int i = 0; i < 2; ++i)
    {
      vtkNew<vtkSphereSource> ball;
      ball->SetThetaResolution(30);
      ball->SetPhiResolution(30);
      ball->SetCenter(0.2 * i, -1.1 * i, 0.1 * i);
      this->addSource(ball);
    }
    this->lookFrom(-0.4, 0.5, 1.0, 2.0);
    this->addPointLight(-0.3, 4.0, 0.5);
    this->addDirectionalLight(0.1, -1.0, 0.2);
  }
};

struct Case
{
  std::string name;
  std::function<void(BallsInSpace&)> change;
  int fewest = 0; ///< pixels that volumes are counted in
  int most = viewPixels;
};

std::vector<Case> cases()
{
  return {
      {"Nothing", [](BallsInSpace&) {}, 1000, viewPixels / 2},
      {"ZFail", [](BallsInSpace& s) { s.pass->SetStencilMethodToZFail(); }, 1000, viewPixels / 2},
      {"Stencil", [](BallsInSpace& s) { s.pass->SetCountBufferToStencil(); }, 1000, viewPixels / 2},
      {"FourSamples", [](BallsInSpace& s) { s.pass->SetSamples(4); }, 1000, viewPixels / 2},
      {"Additive", [](BallsInSpace& s) { s.pass->SetCompositingToAdditive(); }, 1000, viewPixels / 2},
      {"Compute", [](BallsInSpace& s) { s.pass->SetSilhouetteMethod(Pass::SILHOUETTE_COMPUTE); }, 1000,
       viewPixels / 2},
      {"VertexTexture", [](BallsInSpace& s) { s.pass->SetSilhouetteMethod(Pass::SILHOUETTE_VERTEX_TEXTURE); }, 1000,
       viewPixels / 2},
      {"Parallel",
       [](BallsInSpace& s)
       {
         s.renderer->GetActiveCamera()->ParallelProjectionOn();
         s.renderer->GetActiveCamera()->SetParallelScale(2.0);
       },
       1000, viewPixels / 2},
      {"AtTheEdge", [](BallsInSpace& s) { s.renderer->GetActiveCamera()->Yaw(18.0); }, 100, viewPixels / 2},
      {"OutsideTheView", [](BallsInSpace& s) { s.renderer->GetActiveCamera()->Yaw(120.0); }, 0, 0},
      {"EyeInABall",
       [](BallsInSpace& s)
       {
         s.renderer->GetActiveCamera()->SetPosition(0.1, 0.1, 0.1);
         s.renderer->GetActiveCamera()->SetFocalPoint(0.2, -1.0, 0.1);
         s.renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
         s.renderer->GetActiveCamera()->SetClippingRange(0.05, 10.0);
       },
       viewPixels, viewPixels},
      {"Off", [](BallsInSpace& s) { s.pass->SetSavings(Pass::SAVINGS_ALL & ~Pass::SAVINGS_SCISSOR); }, viewPixels,
       viewPixels},
  };
}

class ScissorCase : public testing::TestWithParam<Case>
{
};

std::string nameOf(const testing::TestParamInfo<Case>& info)
{
  return info.param.name;
}

} // namespace

TEST_P(ScissorCase, CountedWhereSurfacesAre_AsCountedEverywhere)
{
  BallsInSpace scene;
  GetParam().change(scene);
  for (int turn = 0; turn < 2; ++turn)
  {
    const DrawnShadows drawn = drawShadows(scene.window, scene.pass);
    EXPECT_GE(scene.pass->GetCountedPixels(), GetParam().fewest);
    EXPECT_LE(scene.pass->GetCountedPixels(), GetParam().most);
    EXPECT_EQ(tellDifferences(drawn, drawByNewPass(scene.window, scene.pass)), "");
    scene.renderer->GetActiveCamera()->Roll(7.0);
  }
}
INSTANTIATE_TEST_SUITE_P(Pass, ScissorCase, testing::ValuesIn(cases()), nameOf);

// The scissor is VTK's own again: the next renderer draws into another part of the window.
TEST(Scissor, TwoRenderers_EachDrawsItsPart)
{
  BallsInSpace scene;
  vtkNew<vtkRenderer> second;
  second->SetBackground(0.9, 0.2, 0.1);
  second->SetViewport(0.5, 0.0, 1.0, 1.0);
  scene.renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  scene.window->AddRenderer(second);
  const std::vector<unsigned char> picture = scene.renderPicture();
  scene.renderer->SetPass(nullptr);
  const std::vector<unsigned char> plain = scene.renderPicture();
  std::size_t background = 0;
  for (std::size_t y = 0; y < 120; ++y)
  {
    for (std::size_t x = 80; x < 160; ++x)
    {
      const std::size_t pixel = 3 * (160 * y + x);
      EXPECT_EQ(picture[pixel], plain[pixel]);
      background += picture[pixel] == 230 || picture[pixel] == 229 ? 1 : 0;
    }
  }
  EXPECT_EQ(background, 80u * 120u);
}
