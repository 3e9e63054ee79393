#include "OutwardOrientation.h"

#include <cstddef>
#include <numeric>
#include <utility>

namespace shadow
{

namespace
{

/// Disjoint sets of triangles. The root of a set is its smallest triangle.
class Components
{
public:
  explicit Components(std::size_t triangles) : parents(triangles)
  {
    std::iota(this->parents.begin(), this->parents.end(), 0u);
  }

  std::uint32_t find(std::uint32_t triangle)
  {
    while (this->parents[triangle] != triangle)
    {
      this->parents[triangle] = this->parents[this->parents[triangle]];
      triangle = this->parents[triangle];
    }
    return triangle;
  }

  void join(std::uint32_t a, std::uint32_t b)
  {
    a = this->find(a);
    b = this->find(b);
    if (a < b)
    {
      this->parents[b] = a;
    }
    else
    {
      this->parents[a] = b;
    }
  }

private:
  std::vector<std::uint32_t> parents;
};

/// Six times the signed volume between each component and a point on it, at the component's root. Measured
/// from a point on the component, a small one far from the origin does not cancel away.
std::vector<double> computeVolumes(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                   const std::vector<glm::vec3>& positions, Components& components)
{
  std::vector<double> volumes(triangles.size(), 0.0);
  for (std::uint32_t triangle = 0; triangle < triangles.size(); ++triangle)
  {
    const std::uint32_t root = components.find(triangle);
    const glm::dvec3 apex(positions[triangles[root][0]]);
    const glm::dvec3 a = glm::dvec3(positions[triangles[triangle][0]]) - apex;
    const glm::dvec3 b = glm::dvec3(positions[triangles[triangle][1]]) - apex;
    const glm::dvec3 c = glm::dvec3(positions[triangles[triangle][2]]) - apex;
    volumes[root] += glm::dot(a, glm::cross(b, c));
  }
  return volumes;
}

} // namespace

void orientOutwards(std::vector<std::array<std::uint32_t, 3>>& triangles, std::vector<Edge>& edges,
                    const std::vector<glm::vec3>& positions, std::vector<std::uint8_t>& flipped)
{
  Components components(triangles.size());
  for (const Edge& edge : edges)
  {
    if (edge.triangles[1] != noTriangle)
    {
      components.join(edge.triangles[0], edge.triangles[1]);
    }
  }

  std::vector<double> volumes = computeVolumes(triangles, positions, components);
  for (const Edge& edge : edges)
  {
    if (edge.triangles[1] == noTriangle)
    {
      volumes[components.find(edge.triangles[0])] = 0.0;
    }
  }

  for (std::uint32_t triangle = 0; triangle < triangles.size(); ++triangle)
  {
    if (volumes[components.find(triangle)] < 0.0)
    {
      std::swap(triangles[triangle][1], triangles[triangle][2]);
      flipped[triangle] ^= 1;
    }
  }
  for (Edge& edge : edges)
  {
    if (volumes[components.find(edge.triangles[0])] < 0.0)
    {
      std::swap(edge.triangles[0], edge.triangles[1]);
    }
  }
}

} // namespace shadow
