// What a renderer's shadows are made with: methods and samples, and what has to give way to what the GL can
// do.
#include "ShadowPassInternals.h"

#include <algorithm>

#include "MethodCheck.h"
#include "OpenGL.h"
#include "ShadowVolumeGPUEffect.h"

namespace
{

constexpr int mostSamples = 32; ///< a pixel of the mask

} // namespace

//------------------------------------------------------------------------------
vtkShadowVolumePass::vtkInternals::RendererState::~RendererState()
{
  this->Release();
}

//------------------------------------------------------------------------------
void vtkShadowVolumePass::vtkInternals::RendererState::Release()
{
  this->Context.release(
      [this](bool contextLost)
      {
        this->Effect->release(contextLost);
        this->Lights.release(contextLost);
      });
}

//------------------------------------------------------------------------------
void vtkShadowVolumePass::vtkInternals::RendererState::Acquire()
{
  this->Context.acquire(
      [this]
      {
        this->Effect->release(true);
        this->Lights.release(true);
        this->Refusals.clear();
        this->RefusedSamples = 0;
      });
}

//------------------------------------------------------------------------------
void vtkShadowVolumePass::vtkInternals::RendererState::Want(const Way& wanted)
{
  if (this->Wanted != wanted)
  {
    this->Wanted = wanted;
    this->Refusals.clear();
    this->RefusedSamples = 0;
  }
}

//------------------------------------------------------------------------------
shadow::SilhouetteMethod
vtkShadowVolumePass::vtkInternals::RendererState::ChooseMethod(int wanted, int samples, std::string& note)
{
  auto method = static_cast<shadow::SilhouetteMethod>(wanted);
  std::string reason;
  while (true)
  {
    const auto refusal = this->Refusals.find(method);
    const std::string missing = refusal != this->Refusals.end()
                                    ? refusal->second
                                    : shadow::findMissing(this->Effect->getCapabilities(), method, samples);
    if (refusal == this->Refusals.end() && missing.empty())
    {
      break;
    }
    reason += (reason.empty() ? "" : "; ") + toString(method) + ": " + missing;
    method = shadow::nextBest(method);
  }
  note = reason.empty() ? "" : reason + "; silhouettes are found by " + toString(method) + " instead";
  return method;
}

//------------------------------------------------------------------------------
void vtkShadowVolumePass::vtkInternals::RendererState::ChooseEffect(shadow::SilhouetteMethod method)
{
  const auto* current = dynamic_cast<const shadow::ShadowVolumeGPUEffect*>(this->Effect.get());
  const bool suits =
      shadow::isOnGPU(method) ? current != nullptr && current->getMethod() == method : current == nullptr;
  if (suits)
  {
    return;
  }
  this->Effect->release(false);
  if (shadow::isOnGPU(method))
  {
    this->Effect = std::make_shared<shadow::ShadowVolumeGPUEffect>(method);
  }
  else
  {
    this->Effect = std::make_shared<shadow::ShadowVolumeEffect>();
  }
}

//------------------------------------------------------------------------------
bool vtkShadowVolumePass::vtkInternals::RendererState::CheckEffect(
    shadow::ShadowVolumeEffect::Settings& settings, std::string& note, std::string& fault)
{
  const auto check = [&]
  {
    const shadow::MethodCheck result =
        shadow::checkMethod(this->Context.getWindow(), *this->Effect, settings, this->View.parallel);
    this->CheckMilliseconds += result.milliseconds;
    return result;
  };
  const auto addNote = [&](const std::string& remedy)
  { note += (note.empty() ? "" : "\n") + toString(settings.silhouetteMethod) + ": " + fault + "; " + remedy; };
  fault = check().fault;
  if (fault.empty())
  {
    return true;
  }
  if ((settings.savings & shadow::Batches) != 0)
  {
    settings.savings &= ~shadow::Batches;
    if (check().fault.empty())
    {
      addNote("small meshes are drawn one by one instead");
      return true;
    }
  }
  const auto choose = [&](shadow::CountBuffer wanted)
  { return this->Effect->chooseCountBuffer(wanted, settings.samples); };
  const shadow::CountBuffer first = choose(settings.countBuffer);
  const bool color = first == shadow::CountBuffer::Color;
  settings.countBuffer = color ? shadow::CountBuffer::Stencil : shadow::CountBuffer::Color;
  if (choose(settings.countBuffer) == first)
  {
    return false;
  }
  const shadow::MethodCheck other = check();
  if (!other.drawn || !other.fault.empty())
  {
    return false;
  }
  addNote(std::string("it counts in ") + (color ? "the stencil" : "colour") + " instead");
  return true;
}

//------------------------------------------------------------------------------
int vtkShadowVolumePass::vtkInternals::ChooseSamples(int wanted, const RendererState& state)
{
  if (wanted > 0)
  {
    return wanted;
  }
  int samples = 1;
  glGetIntegerv(GL_SAMPLES, &samples);
  samples = std::clamp(samples, 1, mostSamples);
  if (samples > 1 && samples == state.RefusedSamples)
  {
    this->AddNote("the GL refuses " + std::to_string(samples) + " samples a pixel of the mask; it has one");
    return 1;
  }
  return samples;
}
