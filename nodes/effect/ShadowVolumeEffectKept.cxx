// The part of ShadowVolumeEffect that tells what of the mask before is still right.
#include <utility>

#include "Savings.h"
#include "ShadowVolumeEffect.h"

namespace shadow
{

MaskInputs ShadowVolumeEffect::collectInputs(const Frame& frame, int samples)
{
  MaskInputs inputs;
  inputs.way = {frame.settings.stencilMethod,     frame.settings.silhouetteMethod, this->countBuffer,
                frame.settings.coplanarTolerance, samples,                         this->viewSamples,
                frame.settings.findHiddenBacks};
  inputs.clipFromWC = frame.view.clipFromWC;
  inputs.width = frame.view.width;
  inputs.height = frame.view.height;
  SurfaceCollector collector;
  this->accept(collector);
  inputs.surfaces = collector.take();
  inputs.lights = frame.lights;
  return inputs;
}

bool ShadowVolumeEffect::keepMask(const Frame& frame, int samples)
{
  const std::optional<MaskInputs> before = std::exchange(this->madeFrom, std::nullopt);
  this->kept = {};
  if ((frame.settings.savings & KeptMasks) == 0)
  {
    return false;
  }
  this->madeFrom = this->collectInputs(frame, samples);
  if (!before || !this->madeFrom->hasViewOf(*before))
  {
    return false;
  }
  this->kept = this->madeFrom->findKept(*before);
  if (frame.lights != before->lights)
  {
    return false;
  }
  this->statistics.keptLights = static_cast<int>(frame.lights.size());
  this->statistics.rebuiltVolumes = 0;
  this->statistics.silhouetteMilliseconds = this->statistics.readBackMilliseconds = 0.0;
  this->statistics.prePassMilliseconds = this->statistics.stencilMilliseconds = 0.0;
  return true;
}

void ShadowVolumeEffect::putMaskAside(vtkOpenGLState* state)
{
  const bool possible = this->target.getSamples() == 1 || this->capabilities.sampleShading;
  if (!this->kept.isEmpty() && !(possible && this->target.putMaskAside(state)))
  {
    this->kept = {};
  }
}

} // namespace shadow
