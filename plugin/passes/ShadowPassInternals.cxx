#include "ShadowPassInternals.h"

#include <algorithm>

#include <vtkOpenGLState.h>

#include "OpenGL.h"
#include "Savings.h"
#include "Stopwatch.h"

static_assert(int{vtkShadowVolumePass::SAVINGS_KEPT_MASKS} == int{shadow::KeptMasks} &&
              int{vtkShadowVolumePass::SAVINGS_BATCHES} == int{shadow::Batches} &&
              int{vtkShadowVolumePass::SAVINGS_SCISSOR} == int{shadow::Scissor} &&
              int{vtkShadowVolumePass::SAVINGS_ALL} == int{shadow::AllSavings});

//------------------------------------------------------------------------------
vtkShadowVolumePass::vtkInternals::RendererState&
vtkShadowVolumePass::vtkInternals::GetState(vtkOpenGLRenderer* renderer, vtkOpenGLRenderWindow* window)
{
  RendererState& state = this->Renderers.get(renderer, window);
  state.Acquire();
  return state;
}

//------------------------------------------------------------------------------
bool vtkShadowVolumePass::vtkInternals::PrepareMask(vtkShadowVolumePass* self, const vtkRenderState* s,
                                                    vtkOpenGLRenderer* renderer,
                                                    vtkOpenGLRenderWindow* window)
{
  RendererState& state = this->GetState(renderer, window);
  this->Current = &state;
  this->Drawn = shadow::drawnProps(s);
  this->Status = STATUS_OK;
  this->Message.clear();
  this->Remark.clear();
  this->Skipped.clear();
  this->HiddenBacks.clear();
  this->ShadowLights = 0;
  this->LightingPasses = 0;
  this->LightingMilliseconds = 0.0;

  this->SceneMilliseconds = 0.0;
  state.CheckMilliseconds = 0.0;
  state.View = shadow::currentView(renderer, window);
  if (const std::string fault = shadow::findFault(state.View); !fault.empty())
  {
    this->AddMessage(fault);
    this->Status = STATUS_NOT_SUPPORTED;
    return false;
  }
  const shadow::LightList lights = shadow::collectLights(renderer);

  if (!this->RenderMask(self, state, lights))
  {
    return false;
  }
  for (const std::string& message : lights.messages)
  {
    this->AddMessage(message);
  }
  for (const std::string& message : state.ShaderMessages)
  {
    this->AddMessage(message);
  }

  this->CollectHiddenBacks(state);
  this->ShadowLights = static_cast<int>(lights.lights.size());
  this->Skipped = state.Builder.getSkipped();
  const auto& culled = state.Effect->getStatistics().skipped;
  this->Skipped.insert(culled.begin(), culled.end());
  this->Hook.strength = lights.attenuation;
  std::transform(this->Hook.strength.begin(), this->Hook.strength.end(), this->Hook.strength.begin(),
                 [&](float attenuation) { return static_cast<float>(self->ShadowIntensity) * attenuation; });
  this->Hook.samples = state.Effect->getTarget().getSamples();
  this->Hook.knowsCoverage = state.Effect->getCapabilities().sampleCoverage;
  if (this->Hook.samples != state.ShaderSamples)
  {
    state.ShaderSamples = this->Hook.samples;
    state.ShaderTime.Modified();
    state.ShaderMessages.clear();
  }
  if (self->Compositing == COMPOSITING_MASK)
  {
    state.Lights.release();
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowVolumePass::vtkInternals::RenderMask(vtkShadowVolumePass* self, RendererState& state,
                                                   const shadow::LightList& lights)
{
  shadow::ShadowVolumeEffect::Settings settings;
  settings.stencilMethod = static_cast<shadow::StencilMethod>(self->StencilMethod);
  settings.coplanarTolerance = self->CoplanarTolerance;
  settings.savings = self->Savings;
  state.Want({self->SilhouetteMethod, self->CountBuffer, self->Samples, state.View.parallel});
  settings.samples = this->ChooseSamples(self->Samples, state);
  settings.waitAfterStages = self->MeasureStages;
  while (true)
  {
    std::string note;
    std::string error;
    settings.countBuffer = static_cast<shadow::CountBuffer>(self->CountBuffer);
    settings.silhouetteMethod = state.ChooseMethod(self->SilhouetteMethod, settings.samples, note);
    state.ChooseEffect(settings.silhouetteMethod);
    const bool right = state.CheckEffect(settings, note, error);
    const shadow::Stopwatch scene;
    this->UpdateScene(self, state);
    settings.findHiddenBacks = !state.Builder.mayBeSeenThrough();
    this->SceneMilliseconds += scene.getMilliseconds();
    if (right &&
        state.Effect->renderMask(state.Context.getWindow(), state.View, lights.lights, settings, error))
    {
      this->UsedMethod = static_cast<int>(settings.silhouetteMethod);
      this->AddNote(note);
      return true;
    }
    if (!shadow::isOnGPU(settings.silhouetteMethod))
    {
      // It was not the method's fault.
      state.Refusals.clear();
      if (self->Samples == 0 && settings.samples > 1)
      {
        state.RefusedSamples = settings.samples;
        settings.samples = this->ChooseSamples(self->Samples, state);
        continue;
      }
      this->Message.clear();
      this->AddMessage(right ? error : toString(settings.silhouetteMethod) + ": " + error);
      this->Status = STATUS_NOT_SUPPORTED;
      return false;
    }
    state.Refusals[settings.silhouetteMethod] = error;
  }
}

//------------------------------------------------------------------------------
void vtkShadowVolumePass::vtkInternals::UpdateScene(vtkShadowVolumePass* self, RendererState& state)
{
  shadow::SceneBuilder::Settings settings;
  settings.weldTolerance = self->WeldTolerance;
  settings.drawn = this->Drawn;
  settings.isCasting = [this](vtkProp* prop) { return !this->NotCasting.has(prop); };
  if (state.Builder.update(state.Context.getRenderer(), settings, *state.Effect))
  {
    state.ShaderTime.Modified();
    state.ShaderMessages.clear();
  }
  for (const std::string& error : state.Builder.getErrors())
  {
    this->AddMessage(error);
  }
  const std::size_t unlit = state.Builder.countUnlit();
  if (unlit > 0 && unlit == state.Builder.countMirrored())
  {
    this->AddMessage("no shadow shows on any surface: the lighting of all is off");
  }
  else if (unlit > 0)
  {
    this->Remark = "no shadow shows on " + state.Builder.getFirstUnlit() +
                   (unlit > 1 ? " and " + std::to_string(unlit - 1) + " more" : "") + ": lighting is off";
  }
}

//------------------------------------------------------------------------------
void vtkShadowVolumePass::vtkInternals::CollectHiddenBacks(const RendererState& state)
{
  for (const shadow::LargeMesh& mesh : state.Effect->getHiddenBacks())
  {
    // The path ends with the transform and its geode.
    if (vtkProp* actor = state.Builder.findActor(mesh.path[mesh.path.size() - 2]))
    {
      this->HiddenBacks[actor] = mesh.back;
    }
  }
}

//------------------------------------------------------------------------------
void vtkShadowVolumePass::vtkInternals::SetHiddenSide(vtkProp* prop)
{
  const auto hidden = this->HiddenBacks.find(prop);
  if (hidden != this->HiddenBacks.end())
  {
    vtkOpenGLState* state = this->Current->Context.getWindow()->GetState();
    state->vtkglEnable(GL_CULL_FACE);
    state->vtkglCullFace(hidden->second == shadow::FaceCulling::Front ? GL_FRONT : GL_BACK);
  }
}

//------------------------------------------------------------------------------
const shadow::ShadowVolumeEffect::Statistics& vtkShadowVolumePass::vtkInternals::GetStatistics() const
{
  static const shadow::ShadowVolumeEffect::Statistics none;
  return this->Current != nullptr ? this->Current->Effect->getStatistics() : none;
}

//------------------------------------------------------------------------------
void vtkShadowVolumePass::vtkInternals::Release(vtkWindow* window)
{
  this->Renderers.release(window);
  this->Passes.ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkShadowVolumePass::vtkInternals::AddMessage(const std::string& message)
{
  this->Status = std::max<int>(this->Status, STATUS_PARTIAL);
  this->AddNote(message);
}

//------------------------------------------------------------------------------
void vtkShadowVolumePass::vtkInternals::AddNote(const std::string& note)
{
  if (this->Message.find(note) == std::string::npos)
  {
    this->Message += (this->Message.empty() ? "" : "\n") + note;
  }
}
