// GL is left as it was found.

#include <gtest/gtest.h>

#include <vtkCameraPass.h>
#include <vtkLightsPass.h>
#include <vtkObjectFactory.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderState.h>
#include <vtkSequencePass.h>

#include "BallScene.h"
#include "GLInspection.h"
#include "OpenGL.h"

using namespace shadow::test;

namespace
{

/// Notes the GL's state when it is its turn.
class StateReader : public vtkRenderPass
{
public:
  static StateReader* New();
  vtkTypeMacro(StateReader, vtkRenderPass);
  void Render(const vtkRenderState*) override
  {
    this->error = glGetError();
    this->state = readGLState();
  }

  GLStateValues state;
  GLenum error = GL_NO_ERROR;
};
vtkStandardNewMacro(StateReader);

} // namespace

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
      vtkNew<StateReader> before;
      vtkNew<StateReader> after;
      vtkNew<vtkLightsPass> lights;
      vtkNew<vtkRenderPassCollection> passes;
      passes->AddItem(lights);
      passes->AddItem(before);
      passes->AddItem(scene.pass);
      passes->AddItem(after);
      vtkNew<vtkSequencePass> sequence;
      sequence->SetPasses(passes);
      vtkNew<vtkCameraPass> cameraPass;
      cameraPass->SetDelegatePass(sequence);
      scene.renderer->SetPass(cameraPass);
      for (int frame = 0; frame < 3; ++frame)
      {
        scene.window->Render();
        ASSERT_GT(before->state.size(), 50u);
        for (const auto& [name, value] : before->state)
        {
          EXPECT_EQ(after->state[name], value) << name << ", samples " << samples << ", frame " << frame;
        }
        EXPECT_EQ(after->error, static_cast<GLenum>(GL_NO_ERROR));
      }
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
