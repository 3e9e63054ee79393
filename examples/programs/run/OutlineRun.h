#ifndef shadow_examples_OutlineRun_h
#define shadow_examples_OutlineRun_h

#include "OutlineOptions.h"
#include "RenderRun.h"

class vtkShadowVolumePass;
class vtkSilhouettePass;

namespace shadow::examples
{

/// One call of outline_render.
class OutlineRun : public RenderRun
{
public:
  explicit OutlineRun(const OutlineOptions& options);
  ~OutlineRun() override;

protected:
  void attachPasses(vtkRenderer* renderer) override;
  void checkDrawing() override;
  void writeMasks(int frame, nlohmann::ordered_json& report) override;
  nlohmann::ordered_json describeSettings() const override;
  nlohmann::ordered_json describeFrame(double milliseconds) override;

private:
  OutlineOptions outlineOptions;
  vtkNew<vtkSilhouettePass> outlines;
  vtkNew<vtkShadowVolumePass> shadows;
};

} // namespace shadow::examples

#endif
