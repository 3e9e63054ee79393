#include "GLInspection.h"

#include <gtest/gtest.h>

#include <vtkCameraPass.h>
#include <vtkLightsPass.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderState.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSequencePass.h>

#include "OpenGL.h"

namespace shadow::test
{

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
    GLint active = 0;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
    for (std::size_t unit = 0; unit < this->bound.size(); ++unit)
    {
      glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
      glGenTextures(1, &this->bound[unit]);
      glBindTexture(GL_TEXTURE_2D, this->bound[unit]);
    }
    glActiveTexture(static_cast<GLenum>(active));
    this->state = readGLState();
  }

  /// Frees them. @pre the window's context is current
  void release()
  {
    glDeleteTextures(static_cast<GLsizei>(this->bound.size()), this->bound.data());
  }

  GLStateValues state;
  GLenum error = GL_NO_ERROR;
  std::vector<GLuint> bound; ///< textures to bind before: as many units as there are elements
};
vtkStandardNewMacro(StateReader);

} // namespace

GLStateValues readGLState()
{
  GLStateValues state;
  const auto integers = [&](const char* name, GLenum value, int count)
  {
    GLint values[4] = {0, 0, 0, 0};
    glGetIntegerv(value, values);
    state[name].assign(values, values + count);
  };
#define READ(name, count) integers(#name, name, count)
  READ(GL_CLIP_ORIGIN, 1), READ(GL_CLIP_DEPTH_MODE, 1), READ(GL_PROVOKING_VERTEX, 1),
      READ(GL_LOGIC_OP_MODE, 1);
  READ(GL_VIEWPORT, 4), READ(GL_SCISSOR_BOX, 4), READ(GL_POLYGON_MODE, 1), READ(GL_FRONT_FACE, 1);
  READ(GL_CULL_FACE_MODE, 1), READ(GL_DEPTH_FUNC, 1), READ(GL_DEPTH_WRITEMASK, 1),
      READ(GL_COLOR_WRITEMASK, 4);
  READ(GL_BLEND_SRC_RGB, 1), READ(GL_BLEND_DST_RGB, 1), READ(GL_BLEND_SRC_ALPHA, 1),
      READ(GL_BLEND_DST_ALPHA, 1);
  READ(GL_BLEND_EQUATION_RGB, 1), READ(GL_BLEND_EQUATION_ALPHA, 1);
  READ(GL_STENCIL_FUNC, 1), READ(GL_STENCIL_REF, 1), READ(GL_STENCIL_VALUE_MASK, 1),
      READ(GL_STENCIL_WRITEMASK, 1);
  READ(GL_STENCIL_FAIL, 1), READ(GL_STENCIL_PASS_DEPTH_FAIL, 1), READ(GL_STENCIL_PASS_DEPTH_PASS, 1);
  READ(GL_STENCIL_BACK_FUNC, 1), READ(GL_STENCIL_BACK_REF, 1), READ(GL_STENCIL_BACK_VALUE_MASK, 1);
  READ(GL_STENCIL_BACK_WRITEMASK, 1), READ(GL_STENCIL_BACK_FAIL, 1);
  READ(GL_STENCIL_BACK_PASS_DEPTH_FAIL, 1), READ(GL_STENCIL_BACK_PASS_DEPTH_PASS, 1);
  READ(GL_STENCIL_CLEAR_VALUE, 1), READ(GL_DRAW_FRAMEBUFFER_BINDING, 1), READ(GL_READ_FRAMEBUFFER_BINDING, 1);
  READ(GL_ACTIVE_TEXTURE, 1), READ(GL_DRAW_BUFFER, 1), READ(GL_READ_BUFFER, 1), READ(GL_PACK_ALIGNMENT, 1);
  READ(GL_PACK_ROW_LENGTH, 1), READ(GL_PIXEL_PACK_BUFFER_BINDING, 1), READ(GL_PIXEL_UNPACK_BUFFER_BINDING, 1);
  READ(GL_UNPACK_ROW_LENGTH, 1), READ(GL_TEXTURE_BINDING_2D_ARRAY, 1);
  READ(GL_POINT_SIZE, 1), READ(GL_UNPACK_ALIGNMENT, 1), READ(GL_VERTEX_ARRAY_BINDING, 1),
      READ(GL_RENDERBUFFER_BINDING, 1);
#undef READ
#define ENABLED(name) state[#name] = {glIsEnabled(name)}
  ENABLED(GL_DEPTH_TEST), ENABLED(GL_STENCIL_TEST), ENABLED(GL_BLEND), ENABLED(GL_CULL_FACE);
  ENABLED(GL_SCISSOR_TEST), ENABLED(GL_COLOR_LOGIC_OP), ENABLED(GL_DEPTH_CLAMP),
      ENABLED(GL_POLYGON_OFFSET_FILL);
  ENABLED(GL_MULTISAMPLE), ENABLED(GL_SAMPLE_ALPHA_TO_COVERAGE), ENABLED(GL_RASTERIZER_DISCARD);
  ENABLED(GL_FRAMEBUFFER_SRGB), ENABLED(GL_PRIMITIVE_RESTART), ENABLED(GL_CLIP_DISTANCE0);
#undef ENABLED
  const int active = state["GL_ACTIVE_TEXTURE"].front();
  for (int unit = 0; unit < 6; ++unit)
  {
    glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
    integers(("texture of unit " + std::to_string(unit)).c_str(), GL_TEXTURE_BINDING_2D, 1);
  }
  glActiveTexture(static_cast<GLenum>(active));
  GLfloat depth[2] = {0.0f, 0.0f};
  glGetFloatv(GL_DEPTH_RANGE, depth);
  state["GL_DEPTH_RANGE"] = {static_cast<int>(1000.0f * depth[0]), static_cast<int>(1000.0f * depth[1])};
  GLfloat clear[4] = {0.0f, 0.0f, 0.0f, 0.0f};
  glGetFloatv(GL_DEPTH_CLEAR_VALUE, clear);
  state["GL_DEPTH_CLEAR_VALUE"] = {static_cast<int>(1000.0f * clear[0])};
  return state;
}

void expectGLStateKept(vtkRenderer* renderer, vtkRenderPass* pass, const std::string& where)
{
  vtkNew<StateReader> before;
  vtkNew<StateReader> after;
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(lights);
  passes->AddItem(before);
  passes->AddItem(pass);
  passes->AddItem(after);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> cameraPass;
  cameraPass->SetDelegatePass(sequence);
  renderer->SetPass(cameraPass);
  for (int frame = 0; frame < 3; ++frame)
  {
    before->bound.assign(6, 0);
    renderer->GetRenderWindow()->Render();
    before->release();
    ASSERT_GT(before->state.size(), 50u);
    for (const auto& [name, value] : before->state)
    {
      EXPECT_EQ(after->state[name], value) << name << ", " << where << ", frame " << frame;
    }
    EXPECT_EQ(after->error, static_cast<GLenum>(GL_NO_ERROR));
  }
}

std::size_t countFragments(vtkRenderWindow* window)
{
  window->MakeCurrent();
  GLuint query = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_SAMPLES_PASSED, query);
  window->Render();
  glEndQuery(GL_SAMPLES_PASSED);
  GLuint fragments = 0;
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &fragments);
  glDeleteQueries(1, &query);
  return fragments;
}

std::map<std::string, int> countGLObjects(vtkRenderWindow* window)
{
  window->MakeCurrent();
  std::map<std::string, int> count;
  for (GLuint name = 1; name < 4000; ++name)
  {
    count["textures"] += glIsTexture(name);
    count["buffers"] += glIsBuffer(name);
    count["framebuffers"] += glIsFramebuffer(name);
    count["renderbuffers"] += glIsRenderbuffer(name);
    count["vertex arrays"] += glIsVertexArray(name);
    count["programs"] += glIsProgram(name);
    count["shaders"] += glIsShader(name);
  }
  return count;
}

} // namespace shadow::test
