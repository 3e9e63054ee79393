#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "SEDGeometry.h"
#include "ShadowVolume.h"
#include "SilhouetteFinder.h"

namespace shadow::test
{

/// Every method but brute force, which the others are held against.
std::vector<SilhouetteMethod> otherMethods();

/// Finders of all methods, brute force in front.
std::vector<std::unique_ptr<SilhouetteFinder>> makeAllFinders();

/// Facing as no light would give it: each triangle towards, away or (one in eight, if wanted) neither.
LightFacing makeRandomFacing(std::size_t triangles, std::mt19937& random, bool withNeither);

/// A light of one of eight kinds: around the mesh, far away, directional, along an axis, inside the bounding
/// box, on a vertex, on an edge, in the plane of a triangle.
glm::dvec4 makeLight(const SEDGeometry& geometry, std::mt19937& random, int kind);

/// Expects every finder to find exactly the directed edges, with multiplicity, that the first one finds, in
/// both casting modes.
///
/// @return  false when one does not; a message then says what is missing and what is too much
bool expectSameEdges(const SEDGeometry& geometry, const LightFacing& facing,
                     const std::vector<std::unique_ptr<SilhouetteFinder>>& finders);

} // namespace shadow::test
