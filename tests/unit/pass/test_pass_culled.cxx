// Props that VTK's cullers leave out cast, but neither receive nor hide what lies behind them.

#include <algorithm>
#include <array>
#include <string>

#include <gtest/gtest.h>

#include <vtkImageData.h>

#include "BallScene.h"
#include "ExcludingCuller.h"

using namespace shadow::test;

namespace
{

/// Where a lamp has the ball's shadow fall: beside the ball as the camera sees it, and behind it.
constexpr double lamps[2][3] = {{-1.5, 4.0, 0.0}, {0.0, 2.5, 2.5}};

/// How far the ball's centre is from the way of the light to a point.
double distanceFromBall(const glm::dvec3& pointWC, const glm::dvec3& lampWC)
{
  const glm::dvec3 centre(0.0, 1.0, 0.0);
  const glm::dvec3 way = lampWC - pointWC;
  const double part = std::clamp(glm::dot(centre - pointWC, way) / glm::dot(way, way), 0.0, 1.0);
  return glm::distance(centre, pointWC + part * way);
}

/// Holds the whole table against the ball's shadow as it must be, a pixel around its edge aside.
void expectOnlyTheShadow(BallScene& scene, const glm::dvec3& lampWC, const std::string& what)
{
  const Pixels mask = scene.renderMask(0);
  ASSERT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_OK) << scene.pass->GetStatusMessage();
  int lit = 0;
  int dark = 0;
  int wrong = 0;
  for (double x = -1.9; x < 1.9; x += 0.04)
  {
    for (double z = -1.9; z < 1.9; z += 0.04)
    {
      const glm::dvec3 point(x, 0.0, z);
      const double distance = distanceFromBall(point, lampWC);
      const std::array<int, 2> pixel = scene.toPixel(point);
      const int* size = scene.renderer->GetSize();
      if (pixel[0] < 0 || pixel[1] < 0 || pixel[0] >= size[0] || pixel[1] >= size[1] ||
          (distance > 0.38 && distance < 0.6))
      {
        continue;
      }
      const bool reached = mask.at(static_cast<std::size_t>(pixel[1] * size[0] + pixel[0])) != 0;
      wrong += reached != (distance > 0.5) ? 1 : 0;
      lit += reached ? 1 : 0;
      dark += reached ? 0 : 1;
    }
  }
  EXPECT_EQ(wrong, 0) << what;
  EXPECT_GT(lit, 1000) << what;
  EXPECT_GT(dark, 50) << what;
}

} // namespace

TEST(PassCulled, BallThatIsNotDrawn_CastsButDoesNotReceive)
{
  for (const auto& lamp : lamps)
  {
    BallScene scene;
    scene.lamp->SetPosition(lamp[0], lamp[1], lamp[2]);
    vtkNew<ExcludingCuller> culler;
    culler->excluded = scene.ballActor;
    scene.renderer->AddCuller(culler);
    const glm::dvec3 lampWC(lamp[0], lamp[1], lamp[2]);
    for (const int stencil : {vtkShadowVolumePass::STENCIL_AUTO, vtkShadowVolumePass::STENCIL_ZPASS,
                              vtkShadowVolumePass::STENCIL_ZFAIL})
    {
      for (const int method :
           {vtkShadowVolumePass::SILHOUETTE_AUTO, vtkShadowVolumePass::SILHOUETTE_FACING_TEXTURE,
            vtkShadowVolumePass::SILHOUETTE_VERTEX_TEXTURE, vtkShadowVolumePass::SILHOUETTE_VERTEX_EXTRUSION,
            vtkShadowVolumePass::SILHOUETTE_GEOMETRY_SHADER, vtkShadowVolumePass::SILHOUETTE_COMPUTE})
      {
        scene.pass->SetStencilMethod(stencil);
        scene.pass->SetSilhouetteMethod(method);
        expectOnlyTheShadow(scene, lampWC,
                            "stencil " + std::to_string(stencil) + ", silhouette " + std::to_string(method));
      }
    }
  }
}

TEST(PassCulled, BallThatIsDrawnAgain_MaskAsBefore)
{
  BallScene scene;
  const Pixels before = scene.renderMask(0);
  vtkNew<ExcludingCuller> culler;
  culler->excluded = scene.ballActor;
  scene.renderer->AddCuller(culler);
  EXPECT_GT(countDifferent(scene.renderMask(0), before), 50u);
  culler->excluded = nullptr;
  EXPECT_EQ(countDifferent(scene.renderMask(0), before), 0u);
}

TEST(PassCulled, AnyUse_PictureWithoutStrengthIsVtksOwn)
{
  for (const Use use : allUses)
  {
    BallScene scene;
    attach(scene.renderer, scene.pass, use);
    scene.pass->SetShadowIntensity(0.0);
    vtkNew<ExcludingCuller> culler;
    culler->excluded = scene.ballActor;
    scene.renderer->AddCuller(culler);
    const Pixels ours = scene.renderPicture();
    attachPlainSteps(scene.renderer);
    EXPECT_EQ(countDifferent(ours, scene.renderPicture()), 0u) << toString(use);
  }
}
