#pragma once

#include <glm/glm.hpp>

#include "OutlineScene.h"
#include "SoupPolyData.h"
#include "TestMeshes.h"

namespace shadow::test
{

/// Both techniques, at widths from 1 to 32, against the truth: no spikes, and nearly everything right.
void expectRight(truth::OutlineScene& scene, double leastRight = 0.99);

/// @param nearest  of the near plane; 0: as VTK chooses it
void setCamera(truth::OutlineScene& scene, const glm::dvec3& position, const glm::dvec3& focus,
               double nearest = 0.0);

} // namespace shadow::test
