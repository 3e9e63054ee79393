#include "ShadowRun.h"

#include "Report.h"
#include "UserError.h"

#include <vtkImageData.h>
#include <vtkRenderer.h>
#include <vtkShadowVolumePass.h>

#include <algorithm>
#include <utility>

namespace shadow::examples
{

void setUpShadows(vtkShadowVolumePass* pass, const RenderOptions& options)
{
  pass->SetStencilMethod(options.stencilMethod);
  pass->SetSilhouetteMethod(options.silhouetteMethod);
  pass->SetCompositing(options.compositing);
  pass->SetSamples(options.samples);
  pass->SetMeasureStages(!options.report.empty());
}

ShadowRun::ShadowRun(RenderOptions given)
    : RenderRun("shadow_render", given, std::max<std::size_t>(1, given.lights.size()))
{
}

ShadowRun::~ShadowRun() = default;

void ShadowRun::attachPasses(vtkRenderer* drawn)
{
  setUpShadows(this->pass, this->options);
  drawn->SetPass(this->pass);
}

void ShadowRun::checkDrawing()
{
  const int status = this->pass->GetStatus();
  this->checkStatus(status == vtkShadowVolumePass::STATUS_OK, status == vtkShadowVolumePass::STATUS_PARTIAL,
                    "shadows", this->pass->GetStatusMessage());
}

void ShadowRun::writeMasks(int frame, nlohmann::ordered_json& report)
{
  for (std::size_t light = 0; light < this->options.lights.size(); ++light)
  {
    const std::string name = this->getNames().mask(frame, light);
    vtkNew<vtkImageData> mask;
    if (!this->pass->GetShadowMask(static_cast<int>(light), mask))
    {
      throw UserError(name + ": the pass gives no mask for light " + std::to_string(light));
    }
    this->writeMask(name, mask, report);
  }
}

nlohmann::ordered_json ShadowRun::describeSettings() const
{
  return describeShadowSettings(this->options);
}

nlohmann::ordered_json ShadowRun::describeFrame(double milliseconds)
{
  return describeRendering(this->pass, milliseconds);
}

} // namespace shadow::examples
