#pragma once

#include "FuzzRandom.h"
#include "FuzzScene.h"

namespace shadow::fuzz
{

/// Where a scene made around the origin with a size of about 1 lies in the world.
struct FuzzPlace
{
  double scale = 1.0;
  glm::dvec3 offset{0.0};

  glm::dvec3 toWorld(const glm::dvec3& point) const { return this->scale * point + this->offset; }
};

/// A point, spot or directional light: around the scene or far off, in a plane of triangles, at a corner, on
/// an edge or a face, or near these by down to 1e-13 of the scene, or inside a mesh.
///
/// @pre the scene's meshes are there
FuzzLight makeLight(FuzzRandom& random, const FuzzScene& scene, const FuzzPlace& place);

} // namespace shadow::fuzz
