#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "ShadowVolume.h"
#include "VolumeOracle.h"

namespace shadow::test
{

/// How each triangle faces the light, in arithmetic of the tests' own: see exactSign().
LightFacing faceExactly(const SEDGeometry& geometry, const glm::dvec4& light);

/// The silhouette as the sum over all triangles of their sides, with no table of edges.
EdgeBalance sumSides(const SEDGeometry& geometry, const LightFacing& facing, Casting casting);

EdgeBalance sumSilhouette(const std::vector<SilhouetteEdge>& silhouette);

} // namespace shadow::test
