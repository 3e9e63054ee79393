#include "OutlineRun.h"

#include "Report.h"
#include "ShadowRun.h"
#include "UserError.h"

#include <vtkImageData.h>
#include <vtkRenderer.h>
#include <vtkShadowVolumePass.h>
#include <vtkSilhouettePass.h>

namespace shadow::examples
{
namespace
{

constexpr std::size_t MASKS_A_PICTURE = 1;

} // namespace

OutlineRun::OutlineRun(const OutlineOptions& given)
    : RenderRun("outline_render", given, MASKS_A_PICTURE), outlineOptions(given)
{
}

OutlineRun::~OutlineRun() = default;

void OutlineRun::attachPasses(vtkRenderer* drawn)
{
  const OutlineOptions& given = this->outlineOptions;
  this->outlines->SetLineWidth(given.width);
  this->outlines->SetColor(given.colour[0], given.colour[1], given.colour[2]);
  this->outlines->SetHiddenEdges(given.hidden);
  this->outlines->SetCreaseEdges(given.creaseDegrees.has_value());
  if (given.creaseDegrees)
  {
    this->outlines->SetFeatureAngle(*given.creaseDegrees);
  }
  this->outlines->SetMeasureStages(!this->options.report.empty());
  if (given.withShadows)
  {
    setUpShadows(this->shadows, this->options);
    this->outlines->SetDelegatePass(this->shadows);
  }
  drawn->SetPass(this->outlines);
}

void OutlineRun::checkDrawing()
{
  const int lines = this->outlines->GetStatus();
  this->checkStatus(lines == vtkSilhouettePass::STATUS_OK, lines == vtkSilhouettePass::STATUS_PARTIAL,
                    "outlines", this->outlines->GetStatusMessage());
  if (this->outlineOptions.withShadows)
  {
    const int status = this->shadows->GetStatus();
    this->checkStatus(status == vtkShadowVolumePass::STATUS_OK, status == vtkShadowVolumePass::STATUS_PARTIAL,
                      "shadows", this->shadows->GetStatusMessage());
  }
}

void OutlineRun::writeMasks(int frame, nlohmann::ordered_json& report)
{
  const std::string name = this->getNames().mask(frame, 0);
  vtkNew<vtkImageData> mask;
  if (!this->outlines->GetLineMask(mask))
  {
    throw UserError(name + ": the pass gives no line mask");
  }
  this->writeMask(name, mask, report);
}

nlohmann::ordered_json OutlineRun::describeSettings() const
{
  const OutlineOptions& given = this->outlineOptions;
  nlohmann::ordered_json settings = {{"width", given.width}, {"colour", given.colour}};
  settings["crease"] = given.creaseDegrees ? nlohmann::ordered_json(*given.creaseDegrees) : nullptr;
  settings["hidden"] = given.hidden;
  settings["shadows"] =
      given.withShadows ? describeShadowSettings(this->options) : nlohmann::ordered_json(nullptr);
  return settings;
}

nlohmann::ordered_json OutlineRun::describeFrame(double milliseconds)
{
  nlohmann::ordered_json report = describeOutlines(this->outlines, milliseconds);
  if (this->outlineOptions.withShadows)
  {
    report["shadows"] = describeRendering(this->shadows, milliseconds);
  }
  return report;
}

} // namespace shadow::examples
