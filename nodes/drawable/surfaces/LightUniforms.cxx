#include "LightUniforms.h"

#include <optional>

#include <vtkShaderProgram.h>

#include "OpenGL.h"

namespace shadow
{

void setLightUniforms(vtkShaderProgram* program, const std::vector<Light>& lights, const SceneFrame& frame)
{
  setLightUniforms(static_cast<unsigned int>(program->GetHandle()), lights, frame);
}

void setLightUniforms(unsigned int program, const std::vector<Light>& lights, const SceneFrame& frame)
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
  glUniform1i(glGetUniformLocation(program, "lightCount"), count);
  glUniform4fv(glGetUniformLocation(program, "lightPosition"), maximumLights, positions[0]);
  glUniform3fv(glGetUniformLocation(program, "lightLow"), maximumLights, lows[0]);
  glUniform1iv(glGetUniformLocation(program, "lightBit"), maximumLights, bits);
}

} // namespace shadow
