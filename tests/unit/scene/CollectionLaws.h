#pragma once

#include <cstdint>
#include <memory>

#include <glm/glm.hpp>

#include "Node.h"
#include "SEDGeometry.h"
#include "TestMeshes.h"
#include "VETCollection.h"

namespace shadow::test
{

std::shared_ptr<const SEDGeometry> share(const TriangleSoup& soup, const SEDGeometryOptions& options = {});

/// A child under a transform.
std::shared_ptr<Transform> place(const std::shared_ptr<Node>& child, const glm::dmat4& matrix);

/// A translation.
glm::dmat4 moved(double x, double y, double z);

/// Where a collected vertex is in the world.
glm::dvec3 worldOf(const VETCollection& collection, std::uint32_t vertex);

/// What the ranges say about the arrays holds, and the arrays are what the graph has.
/// @param tolerance  of positions in the world
void expectLaws(const VETCollection& collection, double tolerance);

/// Every edge runs through its first triangle, oriented, as from -> to and through its second as to -> from.
void expectEdgesRunAsTriangles(const VETCollection& collection);

} // namespace shadow::test
