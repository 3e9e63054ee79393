#pragma once

#include <vtkCameraPass.h>

#include "ShadowScene.h"

namespace shadow::benchmarks
{

/// Model on a floor, 640 x 480, a point light above and beside it that moves with every frame.
class MovingLightScene
{
public:
  explicit MovingLightScene(vtkAlgorithm* source);
  ~MovingLightScene();
  MovingLightScene(const MovingLightScene&) = delete;
  MovingLightScene& operator=(const MovingLightScene&) = delete;

  /// Milliseconds of a frame after the light, and the camera if it does, have moved.
  double draw(vtkRenderPass* pass);

  truth::ShadowScene scene;
  bool cameraMoves = false;
  vtkNew<vtkCameraPass> shadowMap; ///< VTK's own shadows of the same scene

private:
  double centre(int axis) const { return 0.5 * (this->bounds[axis] + this->bounds[axis + 1]); }
  void moveLight();

  vtkLight* light = nullptr;
  double bounds[6] = {0, 0, 0, 0, 0, 0};
  double diagonal = 1.0;
  double angle = 0.0;
};

} // namespace shadow::benchmarks
