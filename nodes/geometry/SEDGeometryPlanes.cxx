// The last stages of SEDGeometryBuilder: what is computed once the triangles are connected and oriented.
#include "SEDGeometryBuilder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace shadow
{

namespace
{

double sumOfMagnitudes(const glm::dvec3& v)
{
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

bool comesBefore(const glm::vec3& a, const glm::vec3& b)
{
  return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

} // namespace

void SEDGeometryBuilder::computePlanes()
{
  const auto count = static_cast<std::uint32_t>(this->geometry.triangles.size());
  this->geometry.planes.resize(count);
  this->geometry.reversed.assign(count);
  this->geometry.inputReversed.assign(count);
  this->geometry.planeErrors.resize((count + 63) / 64);
  for (std::uint32_t block = 0; block < this->geometry.planeErrors.size(); ++block)
  {
    double planeScale = 0.0;
    double positionScale = 0.0;
    const std::uint32_t end = std::min(count, 64 * block + 64);
    for (std::uint32_t triangle = 64 * block; triangle < end; ++triangle)
    {
      this->finishTriangle(triangle, planeScale, positionScale);
    }
    // With eps = 2^-53 and P the largest |u.i v.j| + |u.j v.i|: a normal's coordinate is off by 4 eps P, the
    // offset by 7 eps P |p|, and evaluating the plane adds 4 eps (P |L| + P |p|). 12 eps leaves room for the
    // terms of second order.
    this->geometry.planeErrors[block] = {12.0 * 0x1p-53 * planeScale, 12.0 * 0x1p-53 * positionScale};
  }
}

/// Raster order, plane, and how large the plane's rounding errors can be.
void SEDGeometryBuilder::finishTriangle(std::uint32_t triangle, double& planeScale, double& positionScale)
{
  std::array<std::uint32_t, 3>& corners = this->geometry.triangles[triangle];
  const std::vector<glm::vec3>& positions = this->geometry.positions;
  bool odd = false;
  for (const auto& [first, second] : {std::pair(0, 1), std::pair(1, 2), std::pair(0, 1)})
  {
    if (comesBefore(positions[corners[second]], positions[corners[first]]))
    {
      std::swap(corners[first], corners[second]);
      odd = !odd;
    }
  }

  const std::array<glm::dvec3, 3> points = {glm::dvec3(positions[corners[0]]),
                                            glm::dvec3(positions[corners[1]]),
                                            glm::dvec3(positions[corners[2]])};
  const glm::dvec3 u = points[1] - points[0];
  const glm::dvec3 v = points[2] - points[0];
  glm::dvec3 normal = glm::cross(u, v);
  // The corner nearest to the origin gives the offset with the smallest error.
  const glm::dvec3& nearest = *std::min_element(points.begin(), points.end(),
                                                [](const glm::dvec3& a, const glm::dvec3& b)
                                                { return sumOfMagnitudes(a) < sumOfMagnitudes(b); });
  const glm::dvec3 products = glm::abs(glm::dvec3(u.y * v.z, u.z * v.x, u.x * v.y)) +
                              glm::abs(glm::dvec3(u.z * v.y, u.x * v.z, u.y * v.x));
  const double largest = std::max({products.x, products.y, products.z});
  planeScale = std::max(planeScale, largest);
  positionScale = std::max(positionScale, largest * sumOfMagnitudes(nearest));

  if (normal == glm::dvec3(0.0))
  {
    ++this->geometry.report.zeroAreaTriangles;
  }
  if (odd)
  {
    normal = -normal;
    this->geometry.reversed.set(triangle);
  }
  if (odd != (this->flipped[triangle] != 0))
  {
    this->geometry.inputReversed.set(triangle);
  }
  this->geometry.planes[triangle] = {normal, -glm::dot(normal, nearest)};
}

void SEDGeometryBuilder::countEdgesAndBounds()
{
  this->geometry.report.borderEdges = static_cast<std::size_t>(
      std::count_if(this->geometry.edges.begin(), this->geometry.edges.end(),
                    [](const Edge& edge) { return edge.triangles[1] == noTriangle; }));
  for (const glm::vec3& position : this->geometry.positions)
  {
    this->geometry.lowerBound = glm::min(this->geometry.lowerBound, glm::dvec3(position));
    this->geometry.upperBound = glm::max(this->geometry.upperBound, glm::dvec3(position));
  }
  this->geometry.positions.shrink_to_fit();
}

void SEDGeometryBuilder::findCommonPlane()
{
  const auto first = std::find_if(this->geometry.planes.begin(), this->geometry.planes.end(),
                                  [](const TrianglePlane& plane) { return plane.normal != glm::dvec3(0.0); });
  if (first == this->geometry.planes.end())
  {
    return;
  }
  const glm::dvec4 plane = glm::dvec4(first->normal, first->offset) / glm::length(first->normal);
  const double tolerance = 1e-6 * glm::distance(this->geometry.lowerBound, this->geometry.upperBound);
  const bool common = std::all_of(this->geometry.positions.begin(), this->geometry.positions.end(),
                                  [&](const glm::vec3& position) {
                                    return std::abs(glm::dot(plane, glm::dvec4(position, 1.0))) <= tolerance;
                                  });
  if (common)
  {
    this->geometry.commonPlane = plane;
  }
}

} // namespace shadow
