#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "TestMeshes.h"

namespace shadow::test
{

/// Flat meshes in the plane x = 0, seen from +x, whose faces without area find a side in different ways, or
/// none: the last one's has its longest edge on the border. No eye sees a line but borders.
inline std::vector<NamedMesh> makeFlatWithoutArea()
{
  const auto upright = [](std::vector<glm::dvec2> flat, std::vector<std::array<std::uint32_t, 3>> triangles)
  {
    TriangleSoup soup;
    for (const glm::dvec2& point : flat)
    {
      soup.points.emplace_back(0.0, point.x, point.y);
    }
    soup.triangles = std::move(triangles);
    return soup;
  };
  std::vector<NamedMesh> meshes;
  meshes.push_back({"two across their longest edge",
                    upright({{-1, 0}, {1, 0}, {-0.3, 0}, {0.3, 0}, {0, 1}, {0, -1}},
                            {{0, 2, 4}, {2, 1, 4}, {0, 1, 2}, {1, 0, 3}, {3, 0, 5}, {1, 3, 5}})});
  meshes.push_back(
      {"a third one leads to them",
       upright({{-1, 0}, {1, 0}, {-0.3, 0}, {0.3, 0}, {0, 1}, {0, -1}, {-0.6, 0}},
               {{0, 6, 4}, {6, 2, 4}, {0, 2, 6}, {2, 1, 4}, {0, 1, 2}, {1, 0, 3}, {3, 0, 5}, {1, 3, 5}})});
  meshes.push_back({"across its longest edge", upright({{-1, 0}, {0, 0}, {1, 0}, {0, 1}, {0, -1}},
                                                       {{0, 1, 3}, {1, 2, 3}, {0, 4, 2}, {0, 2, 1}})});
  meshes.push_back({"border", upright({{-1, 0}, {0, 0}, {1, 0}, {0, 1}}, {{0, 1, 3}, {1, 2, 3}, {0, 2, 1}})});
  return meshes;
}

} // namespace shadow::test
