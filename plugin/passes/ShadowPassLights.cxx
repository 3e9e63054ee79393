// Additive compositing: a picture of what each light adds.
#include "ShadowPassInternals.h"

#include <algorithm>

#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkOpenGLState.h>
#include <vtkRenderState.h>

#include "OpenGL.h"

namespace
{

/// Whether a light is negative: a colour buffer has no place for that.
bool takesLightAway(vtkRenderer* renderer)
{
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    if (light->GetSwitch() != 0 && light->GetIntensity() < 0.0)
    {
      return true;
    }
  }
  return false;
}

} // namespace

//------------------------------------------------------------------------------
bool vtkShadowVolumePass::vtkInternals::BeginLights(const vtkRenderPass* opaque)
{
  std::string error = "lights cannot be added one by one under ambient occlusion or hidden line "
                      "removal, to what is blended, without a depth test or where one takes light away";
  RendererState& current = *this->Current;
  const bool ready = this->Passes.isPlain(opaque) && !takesLightAway(current.Context.getRenderer()) &&
                     !current.Builder.isAnyBlendedAsOpaque() && glIsEnabled(GL_DEPTH_TEST) == GL_TRUE &&
                     current.Lights.begin(current.Context.getWindow()->GetState(), error);
  if (!ready)
  {
    this->AddNote(error + "; they are drawn in one pass instead");
  }
  return ready;
}

//------------------------------------------------------------------------------
void vtkShadowVolumePass::vtkInternals::AddLights(const vtkRenderState* s, vtkRenderPass* opaque)
{
  shadow::LightTarget& target = this->Current->Lights;
  vtkOpenGLRenderWindow* window = this->Current->Context.getWindow();
  vtkOpenGLState* state = window->GetState();
  const bool clipControl = this->Current->Effect->getCapabilities().clipControl;
  const vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  const vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  const vtkOpenGLState::ScopedglDepthFunc depthFunction(state);
  GLint function = GL_LESS;
  glGetIntegerv(GL_DEPTH_FUNC, &function);
  this->FirstShows = function == GL_LESS || function == GL_GREATER;
  state->vtkglDepthFunc(GL_EQUAL);
  // Alpha, cleared to 0, tells where a surface has been drawn. A float would not stay at 1 when added up.
  GLint equations[2] = {GL_FUNC_ADD, GL_FUNC_ADD};
  glGetIntegerv(GL_BLEND_EQUATION_RGB, &equations[0]);
  glGetIntegerv(GL_BLEND_EQUATION_ALPHA, &equations[1]);
  state->vtkglBlendEquationSeparate(GL_FUNC_ADD, GL_MAX);
  const std::size_t lights = std::min<std::size_t>(this->Hook.strength.size(), shadow::maximumLights);
  for (std::size_t light = 0; light < lights; ++light)
  {
    this->Hook.pass = static_cast<int>(light);
    target.beginLight(state);
    for (int i = 0; i < s->GetPropArrayCount(); ++i)
    {
      vtkProp* prop = s->GetPropArray()[i];
      vtkRenderState one(s->GetRenderer());
      one.SetPropArrayAndCount(&prop, 1);
      one.SetFrameBuffer(s->GetFrameBuffer());
      one.SetRequiredKeys(s->GetRequiredKeys());
      this->BlendLight(false);
      opaque->Render(&one);
    }
    if (!target.addLight(window, clipControl))
    {
      this->AddMessage("the GL refuses the shader that adds a light");
    }
    ++this->LightingPasses;
  }
  target.end(state);
  state->vtkglBlendEquationSeparate(static_cast<GLenum>(equations[0]), static_cast<GLenum>(equations[1]));
}

//------------------------------------------------------------------------------
void vtkShadowVolumePass::vtkInternals::BlendLight(bool addsLight)
{
  if (this->Hook.pass < 0)
  {
    return;
  }
  vtkOpenGLState* state = this->Current->Context.getWindow()->GetState();
  state->vtkglEnable(GL_BLEND);
  const GLenum source = this->FirstShows ? GL_ONE_MINUS_DST_ALPHA : GL_ONE;
  const GLenum before = this->FirstShows ? GL_ONE : GL_ZERO;
  state->vtkglBlendFuncSeparate(addsLight ? source : GL_ZERO, before, GL_ONE, before);
}
