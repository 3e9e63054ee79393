#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

namespace shadow
{

class SEDGeometry;

/// The triangles of a geometry as the pre-pass draws them: each has a vertex of its own, its last in raster order,
/// that carries the triangle's bits; the other corners are shared. This spares the gl_PrimitiveID that would make a
/// software rasteriser copy every corner of every triangle.
struct PrePassMesh
{
  std::vector<glm::vec3>
      positions; ///< [t] is the last corner of triangle t; after these, corners that are last nowhere
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< in the geometry's order
};

/// @par Cost  O(triangles)
PrePassMesh makePrePassMesh(const SEDGeometry& geometry);

} // namespace shadow
