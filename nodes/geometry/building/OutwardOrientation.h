#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "SEDGeometry.h"

namespace shadow
{

/// Turns closed components inside out whose signed volume is negative, so that their normals look outwards.
///
/// A component is what edges connect. One with a border is left as it is.
///
/// @param triangles  oriented alike within each component; those turned are rewritten
/// @param edges      of the triangles; their two triangles trade places where these were turned
/// @param flipped    one entry a triangle, toggled where it was turned
/// @par Cost  O(triangles); 13 bytes a triangle
void orientOutwards(std::vector<std::array<std::uint32_t, 3>>& triangles, std::vector<Edge>& edges,
                    const std::vector<glm::vec3>& positions, std::vector<std::uint8_t>& flipped);

} // namespace shadow
