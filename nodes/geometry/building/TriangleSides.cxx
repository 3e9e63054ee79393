#include "TriangleSides.h"

#include <utility>

namespace shadow
{

TriangleSides::TriangleSides(const std::vector<Edge>& edges, std::size_t triangles) : sides(triangles)
{
  std::vector<std::uint8_t> found(this->sides.size(), 0);
  for (std::uint32_t edge = 0; edge < edges.size(); ++edge)
  {
    for (const std::uint32_t direction : {0u, 1u})
    {
      const std::uint32_t triangle = edges[edge].triangles[direction];
      if (triangle != noTriangle)
      {
        this->sides[triangle][found[triangle]++] = 2 * edge + direction;
      }
    }
  }
  for (std::array<std::uint32_t, 3>& triangle : this->sides)
  {
    if (getSideVertices(edges, triangle[0])[1] != getSideVertices(edges, triangle[1])[0])
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
}

} // namespace shadow
