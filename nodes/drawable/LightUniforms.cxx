#include "LightUniforms.h"

#include <optional>

#include <vtkShaderProgram.h>

namespace shadow
{

void setLightUniforms(vtkShaderProgram* program, const std::vector<Light>& lights, const SceneFrame& frame)
{
  float positions[maximumLights][4] = {};
  float lows[maximumLights][3] = {};
  int bits[maximumLights] = {};
  int count = 0;
  for (const Light& light : lights)
  {
    const std::optional<SceneLight> scene = lightToScene(light, frame);
    if (scene && count < maximumLights)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        positions[count][axis] = scene->position.high[axis];
        lows[count][axis] = scene->position.low[axis];
      }
      positions[count][3] = scene->w;
      bits[count] = light.index;
      ++count;
    }
  }
  program->SetUniformi("lightCount", count);
  program->SetUniform4fv("lightPosition", maximumLights, positions);
  program->SetUniform3fv("lightLow", maximumLights, lows);
  program->SetUniform1iv("lightBit", maximumLights, bits);
}

} // namespace shadow
