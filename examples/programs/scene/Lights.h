#ifndef shadow_examples_Lights_h
#define shadow_examples_Lights_h

#include "OptionValues.h"

#include <vtkBoundingBox.h>

#include <vector>

class vtkRenderer;

namespace shadow::examples
{

/// A point light above and to the left of the models, so that their shadow falls beside them.
LightOption chooseLight(const vtkBoundingBox& models);

/// Whether some part of a box may lie in the light's cone. Point and directional lights reach everything.
bool canReach(const LightOption& light, const vtkBoundingBox& box);

/// The light turned about the upright axis (y) through a point, against the clock as seen from above.
LightOption turnLight(const LightOption& light, const Vector3& centre, double degrees);

/// Makes these the renderer's only lights. Several are dimmed, so that together they do not wash the picture
/// out.
void setLights(vtkRenderer* renderer, const std::vector<LightOption>& lights);

} // namespace shadow::examples

#endif
