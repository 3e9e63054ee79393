// GL is left as it was found.

#include <string>

#include <gtest/gtest.h>

#include "BallScene.h"
#include "GLInspection.h"
#include "OpenGL.h"

using namespace shadow::test;

TEST(PassState, AsFoundAfterEveryRendering)
{
  for (const int compositing :
       {vtkShadowVolumePass::COMPOSITING_MASK, vtkShadowVolumePass::COMPOSITING_ADDITIVE})
  {
    for (const int samples : {1, 4})
    {
      BallScene scene;
      scene.pass->SetScope(vtkShadowVolumePass::SCOPE_OPAQUE);
      scene.pass->SetCompositing(compositing);
      scene.pass->SetSamples(samples);
      expectGLStateKept(scene.renderer, scene.pass, "samples " + std::to_string(samples));
    }
  }
}

TEST(PassState, NoGLErrors)
{
  BallScene scene;
  scene.addPointLight(1.0, 3.0, 1.0);
  for (int i = 0; i < 12; ++i)
  {
    scene.pass->SetCompositing(i % 2);
    scene.pass->SetSamples(i % 3 == 0 ? 4 : 1);
    scene.pass->SetStencilMethod(i % 3);
    scene.window->SetSize(100 + 13 * i, 150 - 7 * i);
    scene.renderMask();
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << i;
  }
  scene.pass->ReleaseGraphicsResources(scene.window);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}
