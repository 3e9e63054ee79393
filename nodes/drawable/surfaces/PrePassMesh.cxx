#include "PrePassMesh.h"

#include <cstddef>
#include <limits>

#include "SEDGeometry.h"

namespace shadow
{

PrePassMesh makePrePassMesh(const SEDGeometry& geometry)
{
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  const auto& triangles = geometry.getTriangles();
  std::vector<std::uint32_t> copyOf(geometry.getPositions().size(), none);
  PrePassMesh mesh;
  mesh.triangles = triangles;
  mesh.positions.reserve(triangles.size() + triangles.size() / 8);
  for (std::size_t triangle = 0; triangle < triangles.size(); ++triangle)
  {
    const std::uint32_t last = triangles[triangle][2];
    mesh.positions.push_back(geometry.getPositions()[last]);
    mesh.triangles[triangle][2] = static_cast<std::uint32_t>(triangle);
    copyOf[last] = copyOf[last] == none ? static_cast<std::uint32_t>(triangle) : copyOf[last];
  }
  for (auto& triangle : mesh.triangles)
  {
    for (const std::size_t corner : {0, 1})
    {
      std::uint32_t& copy = copyOf[triangle[corner]];
      if (copy == none)
      {
        copy = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back(geometry.getPositions()[triangle[corner]]);
      }
      triangle[corner] = copy;
    }
  }
  return mesh;
}

} // namespace shadow
