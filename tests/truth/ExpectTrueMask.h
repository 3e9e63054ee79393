#pragma once

#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "ShadowScene.h"

namespace shadow::truth
{

/// The most wrong certain pixels per million that a mask may have.
constexpr double wrongPerMillionLimit = 20.0;

inline const char* nameOfStencilMethod(int method)
{
  return method == vtkShadowVolumePass::STENCIL_ZPASS   ? "ZPass"
         : method == vtkShadowVolumePass::STENCIL_ZFAIL ? "ZFail"
                                                        : "Auto";
}

/// Renders, and expects the mask of a light to be true. The figure is printed and recorded as a property of
/// the test.
///
/// @param what  tells this rendering from others in the test
inline void expectTrueMask(ShadowScene& scene, const SceneTruth& truth, const std::string& what,
                           int light = 0)
{
  const MaskError error = scene.compare(truth, light);
  std::printf("%-24s %7.2f wrong certain pixels per million (%zu of %zu)\n", what.c_str(),
              error.wrongCertainPerMillion, error.wrongCertain, error.pixels);
  testing::Test::RecordProperty(what + "WrongCertainPerMillion",
                                std::to_string(error.wrongCertainPerMillion));
  EXPECT_LE(error.wrongCertainPerMillion, wrongPerMillionLimit)
      << what << ", first at pixel "
      << (error.firstWrongPixels.empty() ? std::string("none")
                                         : std::to_string(error.firstWrongPixels.front().x) + ", " +
                                               std::to_string(error.firstWrongPixels.front().y));
}

/// Expects a light's mask to be true by each of the three stencil methods, and by every silhouette method.
inline void expectTrueMaskByEveryMethod(ShadowScene& scene, int light = 0)
{
  scene.window->Render();
  const SceneTruth truth = scene.makeTruth(light);
  const auto expectTrue = [&](const std::string& what)
  {
    expectTrueMask(scene, truth, what, light);
    EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_OK) << scene.pass->GetStatusMessage();
  };
  for (const int method : {vtkShadowVolumePass::STENCIL_ZPASS, vtkShadowVolumePass::STENCIL_ZFAIL,
                           vtkShadowVolumePass::STENCIL_AUTO})
  {
    scene.pass->SetStencilMethod(method);
    expectTrue(nameOfStencilMethod(method));
  }
  // All of them find the same edges, so that one stencil method is enough to see that they are drawn.
  const int first = scene.pass->GetSilhouetteMethod();
  for (int method = scene.pass->GetSilhouetteMethodMinValue();
       method <= scene.pass->GetSilhouetteMethodMaxValue(); ++method)
  {
    if (method != first)
    {
      scene.pass->SetSilhouetteMethod(method);
      expectTrue("Silhouette" + std::to_string(method));
      EXPECT_GT(scene.pass->GetNumberOfRebuiltVolumes(), 0) << "volumes of another method were drawn";
    }
  }
  scene.pass->SetSilhouetteMethod(first);
}

} // namespace shadow::truth
