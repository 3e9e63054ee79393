// Every silhouette method of the pass on the GL that is there: what it cannot do it tells, and uses another.
// ctest runs this on GL 3.2 and 3.3 as well.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <vtkActor.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkOpenGLState.h>

#include "BallScene.h"
#include "Capabilities.h"
#include "Light.h"
#include "OpenGL.h"
#include "RefusingGL.h"
#include "SilhouetteMethods.h"

using namespace shadow;
using namespace shadow::test;

namespace
{

/// More balls, which share one mesh, and more lights, up to as many as there may be.
void addCrowd(BallScene& scene)
{
  for (int i = 0; i < 6; ++i)
  {
    vtkActor* actor = scene.addMapper(scene.ballActor->GetMapper());
    actor->SetPosition(1.6 * std::cos(1.0 * i), 0.1 * i - 0.4, 1.6 * std::sin(1.0 * i));
    actor->SetScale(i % 2 == 0 ? 0.5 : -0.4, 0.5, 0.6);
  }
  for (int i = 1; i < maximumLights; ++i)
  {
    const double angle = 0.2 * i;
    if (i % 3 == 0)
    {
      scene.addDirectionalLight(std::cos(angle), -1.5, std::sin(angle));
    }
    else
    {
      scene.addPointLight(3.0 * std::cos(angle), 2.5 + 0.1 * i, 3.0 * std::sin(angle));
    }
  }
}

/// One rendering, the masks of all lights.
std::vector<Pixels> renderMasks(BallScene& scene)
{
  scene.window->Render();
  std::vector<Pixels> masks;
  for (int light = 0; light < maximumLights; ++light)
  {
    masks.push_back(readMask(scene.pass, light));
  }
  return masks;
}

/// @param can     whether the GL can do the method
/// @param reason  why not, as the message tells
void expectComputeOrTold(BallScene& scene, bool can, const std::string& reason)
{
  const truth::SceneTruth truth = scene.makeTruth();
  const auto messages = MessageCounter::observe(scene.pass);
  scene.pass->SetSilhouetteMethod(vtkShadowVolumePass::SILHOUETTE_COMPUTE);
  for (int frame = 0; frame < 3; ++frame)
  {
    EXPECT_LE(scene.compare(truth).wrongCertain, rimPixels);
  }
  const std::string message = scene.pass->GetStatusMessage();
  EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_OK);
  if (can)
  {
    EXPECT_EQ(scene.pass->GetUsedSilhouetteMethod(), vtkShadowVolumePass::SILHOUETTE_COMPUTE);
    EXPECT_EQ(message, "");
    EXPECT_EQ(messages->warnings, 0);
    return;
  }
  EXPECT_EQ(scene.pass->GetUsedSilhouetteMethod(), vtkShadowVolumePass::SILHOUETTE_FACING_TEXTURE_RESIDENT);
  EXPECT_EQ(message.find("compute: " + reason), 0u) << message;
  EXPECT_NE(message.find("; silhouettes are found by facing-texture-resident instead"), std::string::npos)
      << message;
  EXPECT_EQ(messages->warnings, 1);
  // The setting stays what it was, and another method is not bothered.
  EXPECT_EQ(scene.pass->GetSilhouetteMethod(), vtkShadowVolumePass::SILHOUETTE_COMPUTE);
  scene.pass->SetSilhouetteMethod(vtkShadowVolumePass::SILHOUETTE_BRUTE_FORCE);
  scene.window->Render();
  EXPECT_EQ(scene.pass->GetStatusMessage(), "");
}

} // namespace

TEST(GPUMethods, EveryMethod_RunsOrGivesWay_MaskIsTheTruth)
{
  BallScene scene;
  const auto messages = MessageCounter::observe(scene.pass);
  scene.window->Render();
  const truth::SceneTruth truth = scene.makeTruth();
  for (const int method : allMethods(scene.pass))
  {
    for (const int stencil : {vtkShadowVolumePass::STENCIL_ZPASS, vtkShadowVolumePass::STENCIL_ZFAIL})
    {
      SCOPED_TRACE(nameOf(method) + (stencil == vtkShadowVolumePass::STENCIL_ZPASS ? " ZPass" : " ZFail"));
      scene.pass->SetSilhouetteMethod(method);
      scene.pass->SetStencilMethod(stencil);
      EXPECT_LE(scene.compare(truth).wrongCertain, rimPixels);
      EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_OK);
      const bool asked = scene.pass->GetUsedSilhouetteMethod() == method;
      EXPECT_EQ(scene.pass->GetStatusMessage().empty(), asked) << scene.pass->GetStatusMessage();
    }
  }
  EXPECT_EQ(messages->errors, 0) << messages->last;
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(GPUMethods, Compute_WhereItCannotBe_ToldOnceAndFacingTextureInstead)
{
  for (const bool broken : {false, true})
  {
    BallScene scene;
    scene.window->Render();
    const Capabilities capabilities = queryCapabilities();
    std::unique_ptr<ShaderRefusal> refusal;
    if (broken)
    {
      refusal = std::make_unique<ShaderRefusal>(GL_COMPUTE_SHADER);
    }
    const std::string tooOld = "needs OpenGL 4.3, this context has " + capabilities.version + ";";
    expectComputeOrTold(scene, capabilities.compute && !broken,
                        capabilities.compute ? "facing.comp does not " : tooOld);
  }
}

TEST(GPUMethods, NextBest_EndsOnTheCPU)
{
  vtkNew<vtkShadowVolumePass> pass;
  for (const int method : allMethods(pass))
  {
    auto next = static_cast<SilhouetteMethod>(method);
    for (int step = 0; isOnGPU(next); ++step)
    {
      ASSERT_LT(step, 4) << nameOf(method);
      next = nextBest(next);
    }
    EXPECT_EQ(next == SilhouetteMethod::BruteForce,
              isOnGPU(static_cast<SilhouetteMethod>(method)) ||
                  method == vtkShadowVolumePass::SILHOUETTE_BRUTE_FORCE);
  }
}

TEST(GPUMethods, WithoutSampleShading_SeveralSamplesAreCountedInAStencil)
{
  Capabilities capabilities;
  capabilities.usable = capabilities.compute = true;
  capabilities.version = "3.2";
  EXPECT_EQ(findMissing(capabilities, SilhouetteMethod::Compute, 1), "");
  for (const SilhouetteMethod method :
       {SilhouetteMethod::FacingTextureResident, SilhouetteMethod::VertexTexture,
        SilhouetteMethod::VertexExtrusion, SilhouetteMethod::Compute})
  {
    EXPECT_NE(findMissing(capabilities, method, 4), "") << toString(method);
  }
  EXPECT_EQ(findMissing(capabilities, SilhouetteMethod::FacingTexture, 4), "");
  EXPECT_EQ(findMissing(capabilities, SilhouetteMethod::BruteForce, 4), "");
}

TEST(GPUMethods, SeveralSamples_EveryMethodHasTheSameMask)
{
  BallScene scene;
  scene.pass->SetSamples(4);
  scene.pass->SetSilhouetteMethod(vtkShadowVolumePass::SILHOUETTE_BRUTE_FORCE);
  const Pixels expected = scene.renderMask();
  for (const int method : allMethods(scene.pass))
  {
    scene.pass->SetSilhouetteMethod(method);
    EXPECT_LE(countDifferent(expected, scene.renderMask()), 2u) << nameOf(method);
    EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_OK) << nameOf(method);
  }
}

TEST(GPUMethods, ManyActorsAndLights_EveryMethodHasTheSameMasks)
{
  BallScene scene;
  addCrowd(scene);
  scene.pass->SetSilhouetteMethod(vtkShadowVolumePass::SILHOUETTE_BRUTE_FORCE);
  const std::vector<Pixels> expected = renderMasks(scene);
  for (const Pixels& mask : expected)
  {
    EXPECT_GT(countValue(mask, 0), 100u);
  }
  for (const int method : allMethods(scene.pass))
  {
    scene.pass->SetSilhouetteMethod(method);
    const std::vector<Pixels> masks = renderMasks(scene);
    std::size_t different = 0;
    for (std::size_t light = 0; light < masks.size(); ++light)
    {
      different += countDifferent(expected[light], masks[light]);
    }
    std::printf("%-24s %zu of %zu mask pixels differ\n", nameOf(method).c_str(), different,
                masks.size() * masks[0].size());
    EXPECT_LE(different, 20u) << nameOf(method);
  }
}

TEST(GPUMethods, AfterRendering_NothingIsLeftBound)
{
  BallScene scene;
  for (const int method : allMethods(scene.pass))
  {
    SCOPED_TRACE(nameOf(method));
    scene.pass->SetSilhouetteMethod(method);
    scene.window->Render();
    std::vector<GLenum> bindings = {GL_VERTEX_ARRAY_BINDING, GL_PIXEL_PACK_BUFFER_BINDING,
                                    GL_ARRAY_BUFFER_BINDING};
    if (queryCapabilities().compute)
    {
      bindings.insert(bindings.end(), {GL_DRAW_INDIRECT_BUFFER_BINDING, GL_SHADER_STORAGE_BUFFER_BINDING,
                                       GL_DISPATCH_INDIRECT_BUFFER_BINDING});
      GLint image = -1;
      glGetIntegeri_v(GL_IMAGE_BINDING_NAME, 0, &image);
      EXPECT_EQ(image, 0);
    }
    for (int unit = 0; unit < 16; ++unit)
    {
      scene.window->GetState()->vtkglActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
      GLint texture = -1;
      glGetIntegerv(GL_TEXTURE_BINDING_2D_ARRAY, &texture);
      EXPECT_EQ(texture, 0) << "unit " << unit;
    }
    for (const GLenum binding : bindings)
    {
      GLint value = -1;
      glGetIntegerv(binding, &value);
      EXPECT_EQ(value, 0) << binding;
    }
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  }
}
