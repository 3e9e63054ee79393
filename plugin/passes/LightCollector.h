#ifndef LightCollector_h
#define LightCollector_h

#include <string>
#include <vector>

#include "Light.h"

class vtkRenderer;

namespace shadow
{

/// The renderer's lights that cast shadows, and how strong each light's shadow is.
struct LightList
{
  std::vector<Light> lights; ///< at most maximumLights
  std::vector<float>
      attenuation; ///< a light that is switched on: vtkLight::ShadowAttenuation, 0 without shadow
  std::vector<std::string> messages; ///< lights that were left out, and why
};

/// Reads the lights as VTK's shaders will see them; follows camera lights and the renderer's user light
/// transform.
/// @pre  the renderer's lights have been updated for its camera
LightList collectLights(vtkRenderer* renderer);

} // namespace shadow

#endif
