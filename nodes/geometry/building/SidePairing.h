#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "EdgeTable.h"
#include "ParallelFor.h"

namespace shadow
{

/// The edges of triangles that are an oriented manifold as they stand: no edge has more than two triangles, those of an
/// edge run through it in opposite directions, and where triangles close around a vertex it has no others. A vertex
/// may have several fans that are open.
///
/// @param edges  every edge once, by the lower one of its triangles, then as this runs
/// @return       false, with @p edges unspecified, when the triangles are no such manifold
/// @pre   the corners of a triangle differ
/// @par Cost    O(triangles), and O(d log(d)) for a vertex of d triangles; 40 bytes a triangle besides the result
bool pairSides(const std::vector<std::array<std::uint32_t, 3>>& triangles, std::size_t vertices,
               const ParallelFor& parallelFor, std::vector<Edge>& edges);

} // namespace shadow
