#ifndef shadow_examples_ShadowRun_h
#define shadow_examples_ShadowRun_h

#include "RenderRun.h"

class vtkShadowVolumePass;

namespace shadow::examples
{

/// Sets a shadow pass up as the options say.
void setUpShadows(vtkShadowVolumePass* pass, const RenderOptions& options);

/// One call of shadow_render.
class ShadowRun : public RenderRun
{
public:
  explicit ShadowRun(RenderOptions options);
  ~ShadowRun() override;

protected:
  void attachPasses(vtkRenderer* renderer) override;
  void checkDrawing() override;
  void writeMasks(int frame, nlohmann::ordered_json& report) override;
  nlohmann::ordered_json describeSettings() const override;
  nlohmann::ordered_json describeFrame(double milliseconds) override;

private:
  vtkNew<vtkShadowVolumePass> pass;
};

} // namespace shadow::examples

#endif
