#pragma once

#include <random>
#include <vector>

#include "TestMeshes.h"

namespace shadow::test
{

/// Triangles between the points of a small grid: full of coplanar neighbours, crowded edges, duplicates,
/// touching fans and triangles without area.
TriangleSoup makeGridSoup(std::mt19937& random);

/// Triangles between few random points: many share an edge, or lie in one plane where points have whole
/// coordinates, or are slivers where one axis is squeezed. Their size goes over 16 orders of magnitude. All
/// of them may be degenerate.
TriangleSoup makeCrowdedSoup(std::mt19937& random);

/// Meshes of many clusters: smooth, dented, open, flat, random, and one that is there twice.
std::vector<NamedMesh> makeLargeMeshes();

} // namespace shadow::test
