#include "FuzzSession.h"

#include <algorithm>

#include "EveryMethod.h"
#include "NearPlaneLight.h"

namespace shadow::fuzz
{

DrawnScene FuzzSession::draw(const FuzzScene& scene)
{
  this->window.show(scene);
  DrawnScene drawn;
  std::vector<FuzzConfig> configs = {FuzzConfig{vtkShadowVolumePass::STENCIL_AUTO},
                                     FuzzConfig{vtkShadowVolumePass::STENCIL_ZFAIL}};
  for (const FuzzConfig& config : scene.configs)
  {
    if (std::find(configs.begin(), configs.end(), config) == configs.end())
    {
      configs.push_back(config);
    }
  }
  drawn.masks.push_back(this->window.draw(configs.front()));
  const truth::Scene triangles = this->window.getTruthScene();
  const truth::View view = this->window.getView();
  const truth::Light light = this->window.getLight();
  drawn.truth = std::make_unique<CertainPixels>(triangles, view, light, scene.doublePoints);
  const truth::PixelRays rays(view, glm::dvec3(0.0));
  const bool mayUseZPass = isNearPlaneLit(triangles, rays, scene.size, light, scene.doublePoints);
  for (auto config = configs.begin() + 1; config != configs.end(); ++config)
  {
    if (config->stencil != vtkShadowVolumePass::STENCIL_ZPASS || mayUseZPass)
    {
      drawn.masks.push_back(this->window.draw(*config));
    }
  }
  return drawn;
}

SceneVerdict FuzzSession::judge(const FuzzScene& scene, std::size_t enough)
{
  const DrawnScene drawn = this->draw(scene);
  return judgeMasks(*drawn.truth, drawn.masks, enough);
}

std::vector<FuzzConfig> listEveryConfig()
{
  std::vector<FuzzConfig> configs;
  const vtkNew<vtkShadowVolumePass> pass;
  for (const truth::ShadowMethod& method : truth::everyMethod(pass))
  {
    configs.push_back({method.stencil, method.silhouette, vtkShadowVolumePass::COMPOSITING_MASK,
                       method.countBuffer});
  }
  for (const int stencil : {vtkShadowVolumePass::STENCIL_AUTO, vtkShadowVolumePass::STENCIL_ZFAIL})
  {
    configs.push_back({stencil});
    configs.back().alone = true;
  }
  configs.push_back({vtkShadowVolumePass::STENCIL_AUTO, 0, vtkShadowVolumePass::COMPOSITING_ADDITIVE});
  configs.push_back({vtkShadowVolumePass::STENCIL_ZFAIL, 0, vtkShadowVolumePass::COMPOSITING_ADDITIVE});
  return configs;
}

} // namespace shadow::fuzz
