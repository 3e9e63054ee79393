// Nothing grows when passes, actors, renderers and windows come and go.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <map>
#include <string>

#include <unistd.h>

#include "BallScene.h"
#include "GLInspection.h"
#include "OpenGL.h"

using namespace shadow::test;

namespace
{

double residentMegabytes()
{
  std::ifstream file("/proc/self/statm");
  double total = 0.0;
  double resident = 0.0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1048576.0;
}

/// In 100 rounds. One mask left behind in each would be 36.
constexpr double tolerableMegabytes = 1.0;

/// Runs something a few times until everything is there, then 100 times more: nothing may have grown. Memory
/// is looked at over up to three such hundreds, since what the allocator and the GL put by grows for a while:
/// a leak grows in each.
template <class Round>
void expectNoGrowth(BallScene& scene, Round&& round)
{
  for (int i = 0; i < 10; ++i)
  {
    round(i);
  }
  const auto objects = countGLObjects(scene.window);
  double smallestGrowth = std::numeric_limits<double>::max();
  for (int hundred = 0; hundred < 3 && smallestGrowth >= tolerableMegabytes; ++hundred)
  {
    const double memory = residentMegabytes();
    for (int i = 0; i < 100; ++i)
    {
      round(i);
    }
    smallestGrowth = std::min(smallestGrowth, residentMegabytes() - memory);
  }
  EXPECT_EQ(countGLObjects(scene.window), objects);
  EXPECT_LT(smallestGrowth, tolerableMegabytes);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

} // namespace

TEST(PassGrowth, Released_NoObjectsOfItsOwnAreLeft)
{
  BallScene scene;
  scene.renderer->SetPass(nullptr);
  scene.window->Render();
  scene.window->Render();
  const auto plain = countGLObjects(scene.window);
  scene.renderer->SetPass(scene.pass);
  scene.window->Render();
  EXPECT_GT(countGLObjects(scene.window)["textures"], plain.at("textures"));
  scene.renderer->SetPass(nullptr);
  scene.pass->ReleaseGraphicsResources(scene.window);
  scene.window->Render();
  auto released = countGLObjects(scene.window);
  for (const char* kind : {"textures", "buffers", "framebuffers", "renderbuffers", "vertex arrays"})
  {
    EXPECT_EQ(released[kind], plain.at(kind)) << kind;
  }
}

TEST(PassGrowth, NewPassAttachedAndDetached100Times_Nothing)
{
  BallScene scene;
  scene.renderer->SetPass(nullptr);
  expectNoGrowth(scene,
                 [&](int i)
                 {
                   vtkNew<vtkShadowVolumePass> pass;
                   pass->SetCompositing(i % 2);
                   attach(scene.renderer, pass, allUses[i % 3]);
                   scene.window->Render();
                   scene.renderer->SetPass(nullptr);
                   scene.window->Render();
                 });
}

TEST(PassGrowth, SamePassToggled100Times_Nothing)
{
  BallScene scene;
  expectNoGrowth(scene,
                 [&](int i)
                 {
                   attach(scene.renderer, scene.pass, allUses[i % 3]);
                   scene.window->Render();
                   scene.renderer->SetPass(nullptr);
                   scene.window->Render();
                 });
}

TEST(PassGrowth, ReleasedAndRendered100Times_Nothing)
{
  BallScene scene;
  expectNoGrowth(scene,
                 [&](int i)
                 {
                   scene.pass->SetSamples(i % 2 == 0 ? 1 : 4);
                   scene.window->Render();
                   scene.pass->ReleaseGraphicsResources(scene.window);
                 });
}

TEST(PassGrowth, SourceChanged100Times_Nothing)
{
  BallScene scene;
  expectNoGrowth(scene,
                 [&](int i)
                 {
                   scene.ball->SetRadius(0.4 + 0.01 * (i % 10));
                   scene.lamp->SetPosition(-1.5 + 0.01 * (i % 7), 4.0, 0.0);
                   scene.window->Render();
                 });
}

TEST(PassGrowth, ActorsAndRenderersComeAndGo100Times_Nothing)
{
  BallScene scene;
  expectNoGrowth(scene,
                 [&](int)
                 {
                   vtkActor* actor = scene.addSource(scene.ball);
                   actor->SetPosition(0.4, 0.0, 0.7);
                   vtkNew<vtkRenderer> renderer;
                   renderer->SetPass(scene.pass);
                   renderer->AddActor(actor);
                   renderer->SetViewport(0.5, 0.5, 1.0, 1.0);
                   scene.window->AddRenderer(renderer);
                   scene.window->Render();
                   scene.window->RemoveRenderer(renderer);
                   scene.renderer->RemoveActor(actor);
                   scene.window->Render();
                 });
}

TEST(PassGrowth, WindowsComeAndGo30Times_Nothing)
{
  vtkNew<vtkShadowVolumePass> pass;
  const auto round = [&]
  {
    BallScene scene;
    scene.renderer->SetPass(pass);
    scene.window->Render();
  };
  for (int i = 0; i < 10; ++i)
  {
    round();
  }
  const double memory = residentMegabytes();
  for (int i = 0; i < 30; ++i)
  {
    round();
  }
  // OSMesa itself keeps some memory for each context.
  EXPECT_LT(residentMegabytes() - memory, 10.0 * tolerableMegabytes);
}
