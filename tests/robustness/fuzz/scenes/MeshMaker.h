#pragma once

#include <vector>

#include "FuzzRandom.h"
#include "FuzzScene.h"

namespace shadow::fuzz
{

/// A small random mesh of about the cube from -1 to 1: a soup, points of a lattice, slivers, a fan, a book,
/// an open sheet, or a closed mesh, some of them with holes, mixed winding or triangles that are there twice.
///
/// @post  1 to about 200 triangles
std::vector<FuzzTriangle> makeMesh(FuzzRandom& random);

} // namespace shadow::fuzz
