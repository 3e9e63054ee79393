// Meshes made from others.
#include "TestMeshes.h"

#include <algorithm>
#include <utility>

namespace shadow::test
{

void append(TriangleSoup& soup, const TriangleSoup& other)
{
  const auto offset = static_cast<std::uint32_t>(soup.points.size());
  soup.points.insert(soup.points.end(), other.points.begin(), other.points.end());
  for (const auto& triangle : other.triangles)
  {
    soup.triangles.push_back({triangle[0] + offset, triangle[1] + offset, triangle[2] + offset});
  }
}

void turnInsideOut(TriangleSoup& soup)
{
  for (auto& triangle : soup.triangles)
  {
    std::swap(triangle[1], triangle[2]);
  }
}

void turnRandomly(TriangleSoup& soup, std::uint32_t seed)
{
  std::mt19937 random(seed);
  for (auto& triangle : soup.triangles)
  {
    if (random() & 1u)
    {
      std::swap(triangle[1], triangle[2]);
    }
    std::rotate(triangle.begin(), triangle.begin() + random() % 3, triangle.end());
  }
}

TriangleSoup makeUnshared(const TriangleSoup& soup)
{
  TriangleSoup unshared;
  unshared.points.reserve(3 * soup.triangles.size());
  unshared.triangles.reserve(soup.triangles.size());
  for (const auto& triangle : soup.triangles)
  {
    const auto first = static_cast<std::uint32_t>(unshared.points.size());
    for (const std::uint32_t corner : triangle)
    {
      unshared.points.push_back(soup.points[corner]);
    }
    unshared.triangles.push_back({first, first + 1, first + 2});
  }
  return unshared;
}

} // namespace shadow::test
