#pragma once

#include <cstdint>

#include "FuzzScene.h"

namespace shadow::fuzz
{

/// The scene of a number: always the same one.
///
/// One to four actors, with or without a floor, at a scale from 1e-5 to 1e6 and maybe far from the origin;
/// the light may be in the plane of triangles, on them, or nearer than single precision tells; the eye may
/// be inside meshes and shadows, and the near plane may cut them. Its configs are four ways to draw it,
/// besides Auto and z-fail.
FuzzScene makeScene(std::uint64_t seed, std::uint64_t number);

} // namespace shadow::fuzz
