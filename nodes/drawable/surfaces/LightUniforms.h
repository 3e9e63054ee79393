#pragma once

#include <vector>

#include "Light.h"
#include "SceneFrame.h"

class vtkShaderProgram;

namespace shadow
{

/// Sets lightCount, lightPosition, lightLow and lightBit, as shaders that evaluate facing take them; lights
/// that are not finite are left out. @pre the program is current; at most maximumLights lights
void setLightUniforms(vtkShaderProgram* program, const std::vector<Light>& lights, const SceneFrame& frame);

/// The same for the name of a GL program.
void setLightUniforms(unsigned int program, const std::vector<Light>& lights, const SceneFrame& frame);

} // namespace shadow
