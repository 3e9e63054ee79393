#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "FacingBits.h"

namespace shadow
{

/// Which triangles are copies: an earlier one has the same three corners, wound either way.
///
/// Two solids that touch store the wall between them twice. There neither is a copy, as each closes a solid
/// of its own: triangles that are there twice, connected with one another, are such a wall when wherever they
/// end two or more other triangles meet them.
///
/// @param triangles  three different vertices each, the smallest one first
/// @param vertices   how many there are
/// @return  one entry a triangle, 1 for a copy; empty when there is none
/// @par Cost  O(triangles), but for a sort of those at each vertex
std::vector<std::uint8_t> findCopies(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                     std::size_t vertices);

/// Gives each copy vertices of its own, so that it is nobody's neighbour.
///
/// @param copies     one entry a triangle of the input
/// @param order      for each of @p triangles its place in the input
/// @param triangles  renumbered in place
/// @param positions  three are appended for each copy
/// @return  bit t set: triangle t is a copy
FacingBits setCopiesApart(const std::vector<std::uint8_t>& copies, const std::vector<std::uint32_t>& order,
                          std::vector<std::array<std::uint32_t, 3>>& triangles,
                          std::vector<glm::vec3>& positions);

} // namespace shadow
