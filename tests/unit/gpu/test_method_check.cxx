// What the GL draws wrongly, with no error: the method is found out, told, and another draws the picture.
// ctest runs this on GL 3.2 and 3.3 as well.

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include <vtkCamera.h>

#include "BallScene.h"
#include "Capabilities.h"
#include "FaultyGL.h"
#include "GLInspection.h"
#include "KnownScene.h"
#include "OpenGL.h"
#include "SilhouetteMethods.h"

using namespace shadow;
using namespace shadow::test;

namespace
{

using Answer = KnownScene::Answer;

/// The ball in a window in which nothing of ours has been compiled or tried out.
class FreshScene : public BallScene
{
public:
  FreshScene()
  {
    this->renderer->SetPass(nullptr);
    this->window->Render();
    this->renderer->SetPass(this->pass);
  }
  bool can(int method) const
  {
    return findMissing(queryCapabilities(), static_cast<SilhouetteMethod>(method), 1).empty();
  }
};

/// A picture by the next best method, and a message that names @p method; both the first time and then.
void expectGivenWay(BallScene& scene, int method, const truth::SceneTruth& truth)
{
  scene.pass->SetSilhouetteMethod(method);
  const auto messages = MessageCounter::observe(scene.pass);
  for (int frame = 0; frame < 2; ++frame)
  {
    EXPECT_LE(scene.compare(truth).wrongCertain, rimPixels);
    EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_OK);
    EXPECT_NE(scene.pass->GetUsedSilhouetteMethod(), method);
    EXPECT_EQ(scene.pass->GetStatusMessage().find(nameOf(method) + ": this GL draws shadows wrongly"), 0u)
        << scene.pass->GetStatusMessage();
  }
  EXPECT_EQ(messages->warnings, 1);
  EXPECT_EQ(messages->errors, 0);
}

} // namespace

TEST(MethodCheck, CertainPixels_HaveTheirAnswerAllOver)
{
  for (const bool parallel : {false, true})
  {
    const KnownScene scene(parallel);
    for (std::size_t light = 0; light < scene.getLights().size(); ++light)
    {
      const auto answers = scene.findAnswers(light);
      int counts[3] = {0, 0, 0};
      for (std::size_t i = 0; i < answers.size(); ++i)
      {
        ++counts[static_cast<int>(answers[i])];
        int others = 0;
        for (int sample = 0; sample < 256 && answers[i] != Answer::Uncertain; ++sample)
        {
          int object = 0;
          const glm::dvec2 place(i % KnownScene::side + (sample % 16 + 0.5) / 16.0,
                                 i / KnownScene::side + (sample / 16 + 0.5) / 16.0);
          others += scene.findAnswer(place, light, object) != answers[i] ? 1 : 0;
        }
        EXPECT_EQ(others, 0) << i % KnownScene::side << " " << i / KnownScene::side;
      }
      EXPECT_GT(counts[static_cast<int>(Answer::Shadow)], 80);
      EXPECT_GT(counts[static_cast<int>(Answer::Reached)], 600);
    }
  }
}

TEST(MethodCheck, NoFault_EveryMethodPassesOnceInAContextForEachWayThroughTheGL)
{
  for (const int method : allMethods(FreshScene().pass))
  {
    SCOPED_TRACE(nameOf(method));
    FreshScene scene;
    if (!scene.can(method))
    {
      continue;
    }
    vtkNew<vtkShadowVolumePass> second;
    const auto expectChecked = [&](vtkShadowVolumePass* pass, bool checked, const char* where)
    {
      scene.renderer->SetPass(pass);
      pass->SetSilhouetteMethod(method);
      const Pixels picture = scene.renderPicture();
      EXPECT_EQ(pass->GetCheckMilliseconds() > 0.0, checked) << where;
      EXPECT_EQ(pass->GetStatusMessage(), "") << where;
      EXPECT_EQ(pass->GetUsedSilhouetteMethod(), method) << where;
      EXPECT_EQ(countDifferent(picture, scene.renderPicture()), 0u) << where;
    };
    expectChecked(scene.pass, true, "first");
    expectChecked(scene.pass, false, "again");
    expectChecked(second, false, "another pass of the window");
    scene.pass->ReleaseGraphicsResources(scene.window);
    expectChecked(scene.pass, false, "released");
    scene.renderer->GetActiveCamera()->ParallelProjectionOn();
    expectChecked(scene.pass, true, "parallel view");
    scene.renderer->GetActiveCamera()->ParallelProjectionOff();
    expectChecked(scene.pass, false, "perspective again");
    for (const int samples : {2, 4, 8})
    {
      for (const bool parallel : {false, true})
      {
        scene.pass->SetSamples(samples);
        scene.renderer->GetActiveCamera()->SetParallelProjection(parallel);
        const Pixels picture = scene.renderPicture();
        // A GL may lack what several samples take.
        EXPECT_EQ(scene.pass->GetStatusMessage().find("wrongly"), std::string::npos)
            << scene.pass->GetStatusMessage() << (parallel ? " parallel, " : " ") << samples;
        EXPECT_EQ(countDifferent(picture, scene.renderPicture()), 0u) << parallel << ", " << samples;
      }
    }
    scene.pass->SetSamples(1);
    scene.renderer->GetActiveCamera()->ParallelProjectionOff();
    scene.window->Finalize();
    expectChecked(scene.pass, true, "another context");
  }
}

// Faults of what all methods on the GPU share, and at the place where each differs from the others.
TEST(MethodCheck, DrawsWronglyWithoutAnError_TheMethodGivesWay)
{
  struct Fault
  {
    int method;
    const char* right;
    const char* wrong;
  };
  const Fault faults[] = {
      {vtkShadowVolumePass::SILHOUETTE_FACING_TEXTURE, "texel = facing;", "texel = facing & 0xfffffffeu;"},
      {vtkShadowVolumePass::SILHOUETTE_FACING_TEXTURE_RESIDENT, "texel = facing;",
       "texel = facing & 0x7fffffffu;"},
      {vtkShadowVolumePass::SILHOUETTE_FACING_TEXTURE_RESIDENT, "abs(float(times))", "0.0"},
      {vtkShadowVolumePass::SILHOUETTE_VERTEX_TEXTURE, "(there.x & ~back.x)", "0u"},
      {vtkShadowVolumePass::SILHOUETTE_VERTEX_TEXTURE, "(there.x & back.y) | (there.y & back.x)", "0u"},
      {vtkShadowVolumePass::SILHOUETTE_VERTEX_EXTRUSION, "gl_VertexID / 5", "min(gl_VertexID / 5, 20)"},
      {vtkShadowVolumePass::SILHOUETTE_VERTEX_EXTRUSION, "count *= multiplicity;", ""},
      {vtkShadowVolumePass::SILHOUETTE_COMPUTE, "(there.x & ~back.x)", "0u"},
      {vtkShadowVolumePass::SILHOUETTE_GEOMETRY_SHADER, "i < 4 && (i == 0", "i < 3 && (i == 0"},
      {vtkShadowVolumePass::SILHOUETTE_GEOMETRY_SHADER, "winding * float(turned)", "0.0"},
      {vtkShadowVolumePass::SILHOUETTE_GEOMETRY_SHADER, "winding * float(casts)", "float(casts)"},
      {vtkShadowVolumePass::SILHOUETTE_GEOMETRY_SHADER, "if (darkFan == 1)", "if (darkFan == 2)"},
      {vtkShadowVolumePass::SILHOUETTE_GEOMETRY_SHADER, "handOn(gl_in[2]", "handOn(gl_in[1]"},
  };
  int tried = 0;
  for (const Fault& fault : faults)
  {
    SCOPED_TRACE(nameOf(fault.method) + " without " + fault.right);
    FreshScene scene;
    if (scene.can(fault.method))
    {
      const truth::SceneTruth truth = scene.makeTruth();
      const FaultyShaders faulty(fault.right, fault.wrong);
      expectGivenWay(scene, fault.method, truth);
      EXPECT_GT(faulty.countAltered(), 0);
      ++tried;
    }
  }
  EXPECT_GT(tried, 0); // facing textures need no more than VTK itself does
}

TEST(MethodCheck, IndirectDrawsAreLost_ComputeGivesWay)
{
  FreshScene scene;
  if (!scene.can(vtkShadowVolumePass::SILHOUETTE_COMPUTE))
  {
    GTEST_SKIP() << "no compute shaders";
  }
  const truth::SceneTruth truth = scene.makeTruth();
  const LostIndirectDraws lost;
  expectGivenWay(scene, vtkShadowVolumePass::SILHOUETTE_COMPUTE, truth);
  EXPECT_EQ(scene.pass->GetUsedSilhouetteMethod(), vtkShadowVolumePass::SILHOUETTE_FACING_TEXTURE_RESIDENT);
}

TEST(MethodCheck, OneBufferCountsWrongly_TheOtherCounts)
{
  for (const int method :
       {vtkShadowVolumePass::SILHOUETTE_BRUTE_FORCE, vtkShadowVolumePass::SILHOUETTE_FACING_TEXTURE})
  {
    for (const bool color : {false, true})
    {
      SCOPED_TRACE(nameOf(method) + (color ? " colour" : " stencil"));
      FreshScene scene;
      const truth::SceneTruth truth = scene.makeTruth();
      std::unique_ptr<LostStencilCounts> lost;
      std::unique_ptr<FaultyShaders> faulty;
      if (color)
      {
        faulty = std::make_unique<FaultyShaders>("count == 0.0", "count <= 0.0 || count > 0.0");
      }
      else
      {
        lost = std::make_unique<LostStencilCounts>();
      }
      scene.pass->SetCountBuffer(color ? vtkShadowVolumePass::COUNT_COLOR
                                       : vtkShadowVolumePass::COUNT_STENCIL);
      scene.pass->SetSilhouetteMethod(method);
      for (int frame = 0; frame < 2; ++frame)
      {
        EXPECT_LE(scene.compare(truth).wrongCertain, rimPixels);
        EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_OK);
        EXPECT_EQ(scene.pass->GetUsedSilhouetteMethod(), method);
        const std::string message = scene.pass->GetStatusMessage();
        EXPECT_EQ(message.find(nameOf(method) + ": this GL draws shadows wrongly"), 0u) << message;
        EXPECT_NE(message.find(color ? "counts in the stencil instead" : "counts in colour instead"),
                  std::string::npos)
            << message;
      }
    }
  }
}

TEST(MethodCheck, NothingIsRight_NoShadowsAndTheStatusTells)
{
  for (const int method : allMethods(FreshScene().pass))
  {
    SCOPED_TRACE(nameOf(method));
    FreshScene scene;
    const auto messages = MessageCounter::observe(scene.pass);
    const FaultyShaders faulty("reached = ~(1u <<", "reached = ~(0u <<");
    scene.pass->SetSilhouetteMethod(method);
    for (int frame = 0; frame < 2; ++frame)
    {
      scene.window->Render();
      EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_NOT_SUPPORTED);
      const bool onGPU = isOnGPU(static_cast<SilhouetteMethod>(method));
      const int last = onGPU ? vtkShadowVolumePass::SILHOUETTE_BRUTE_FORCE : method;
      EXPECT_EQ(scene.pass->GetStatusMessage().find(nameOf(last) + ": this GL draws shadows wrongly"), 0u)
          << scene.pass->GetStatusMessage();
      EXPECT_EQ(scene.pass->GetSideTriangles(), 0);
    }
    EXPECT_EQ(messages->warnings, 1);
  }
}

TEST(MethodCheck, GLIsLeftAsFound)
{
  const FreshScene current;
  if (!queryCapabilities().clipControl)
  {
    GTEST_SKIP() << "readGLState() asks for more than this GL has";
  }
  for (const int method : allMethods(FreshScene().pass))
  {
    for (const int samples : {1, 4})
    {
      FreshScene scene;
      scene.pass->SetScope(vtkShadowVolumePass::SCOPE_OPAQUE);
      scene.pass->SetSilhouetteMethod(method);
      scene.pass->SetSamples(samples);
      expectGLStateKept(scene.renderer, scene.pass, nameOf(method));
      EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    }
  }
}
