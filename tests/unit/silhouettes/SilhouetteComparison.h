#pragma once

#include <cstddef>
#include <memory>
#include <random>
#include <vector>

#include <glm/glm.hpp>

#include "SEDGeometry.h"
#include "ShadowVolume.h"
#include "SilhouetteFinder.h"

namespace shadow::test
{

/// Every CPU method but brute force, which the others are held against.
std::vector<SilhouetteMethod> otherMethods();

/// Finders of all CPU methods, brute force in front.
std::vector<std::unique_ptr<SilhouetteFinder>> makeAllFinders();

/// Facing as no light would give it: each triangle towards, away or (one in eight, if wanted) neither.
LightFacing makeRandomFacing(std::size_t triangles, std::mt19937& random, bool withNeither);

/// Expects every finder to find exactly the directed edges, with multiplicity, that the first one finds, in
/// both casting modes.
///
/// @return  false when one does not; a message then says what is missing and what is too much
bool expectSameEdges(const SEDGeometry& geometry, const LightFacing& facing,
                     const std::vector<std::unique_ptr<SilhouetteFinder>>& finders);

/// Has every finder face the light, each in the memory that the one before has used, and expects the bits and
/// edges of the first one.
///
/// @return  as expectSameEdges()
bool expectSameAnswers(const SEDGeometry& geometry, const glm::dvec4& lightMC,
                       const std::vector<std::unique_ptr<SilhouetteFinder>>& finders);

} // namespace shadow::test
