#pragma once

#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "EveryMethod.h"
#include "ShadowScene.h"

namespace shadow::truth
{

/// The most wrong certain pixels per million that a mask may have.
constexpr double wrongPerMillionLimit = 20.0;

/// Renders, and expects the mask of a light to be true. The figure is printed and recorded as a property of
/// the test.
///
/// @param what  tells this rendering from others in the test
inline void expectTrueMask(ShadowScene& scene, const SceneTruth& truth, const std::string& what,
                           int light = 0)
{
  const MaskError error = scene.compare(truth, light);
  std::printf("%-32s %7.2f wrong certain pixels per million (%zu of %zu)\n", what.c_str(),
              error.wrongCertainPerMillion, error.wrongCertain, error.pixels);
  testing::Test::RecordProperty(what + "WrongCertainPerMillion",
                                std::to_string(error.wrongCertainPerMillion));
  EXPECT_LE(error.wrongCertainPerMillion, wrongPerMillionLimit)
      << what << ", first at pixel "
      << (error.firstWrongPixels.empty() ? std::string("none")
                                         : std::to_string(error.firstWrongPixels.front().x) + ", " +
                                               std::to_string(error.firstWrongPixels.front().y));
}

/// Expects a light's mask to be true by every method.
inline void expectTrueMaskByEveryMethod(ShadowScene& scene, int light = 0)
{
  scene.window->Render();
  const SceneTruth truth = scene.makeTruth(light);
  for (const ShadowMethod& method : everyMethod(scene.pass))
  {
    method.use(scene.pass);
    expectTrueMask(scene, truth, method.getName(), light);
    EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_OK) << scene.pass->GetStatusMessage();
  }
}

} // namespace shadow::truth
