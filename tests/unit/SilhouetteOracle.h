#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "ShadowVolume.h"
#include "TestMeshes.h"
#include "VolumeOracle.h"

namespace shadow::test
{

/// Lights of every kind in turn: far and near ones, directions, lights at a vertex, a hair off one, in the
/// plane of a triangle, along one, and within the bounding box.
std::vector<glm::dvec4> makeLights(const SEDGeometry& geometry, std::size_t count, std::uint32_t seed);

/// How each triangle faces the light, in arithmetic of the tests' own: see exactSign().
LightFacing faceExactly(const SEDGeometry& geometry, const glm::dvec4& light);

/// The silhouette as the sum over all triangles of their sides, with no table of edges.
EdgeBalance sumSides(const SEDGeometry& geometry, const LightFacing& facing, Casting casting);

EdgeBalance sumSilhouette(const std::vector<SilhouetteEdge>& silhouette);

/// The same edges with the same multiplicities, in whatever order?
bool areSame(const std::vector<SilhouetteEdge>& left, const std::vector<SilhouetteEdge>& right);

/// The triangles of an OBJ file, polygons as fans.
TriangleSoup readObj(const std::filesystem::path& file);

/// The meshes that are found beside the project; none is fine.
std::vector<NamedMesh> findSharedMeshes();

} // namespace shadow::test
