#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include <glm/glm.hpp>

#include "SEDGeometry.h"

namespace shadow::test
{

/// How many kinds of light makeLight() knows.
inline constexpr int lightKinds = 12;

/// A light, relative to the geometry's origin: around the mesh, far away, a direction, along an axis, inside
/// the bounding box, on a vertex, a hair off one, on an edge, in the plane of a triangle, nearly so, close to
/// the surface, a direction along a triangle.
///
/// @param kind  taken modulo lightKinds
glm::dvec4 makeLight(const SEDGeometry& geometry, std::mt19937& random, int kind);

/// Lights of every kind in turn.
std::vector<glm::dvec4> makeLights(const SEDGeometry& geometry, std::size_t count, std::uint32_t seed);

} // namespace shadow::test
