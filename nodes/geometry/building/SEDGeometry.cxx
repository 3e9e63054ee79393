#include "SEDGeometry.h"

#include <algorithm>
#include <cmath>

namespace shadow
{

namespace
{

template <typename T>
std::size_t bytesOf(const std::vector<T>& values)
{
  return values.capacity() * sizeof(T);
}

} // namespace

TrianglePlane SEDGeometry::getPlane(std::size_t triangle) const
{
  const std::array<std::uint32_t, 3>& corners = this->triangles[triangle];
  const std::array<glm::dvec3, 3> points = {glm::dvec3(this->positions[corners[0]]),
                                            glm::dvec3(this->positions[corners[1]]),
                                            glm::dvec3(this->positions[corners[2]])};
  const glm::dvec3 cross = glm::cross(points[1] - points[0], points[2] - points[0]);
  const glm::dvec3 normal = this->reversed.test(triangle) ? -cross : cross;
  // The corner nearest to the origin gives the offset with the smallest error.
  const auto distance = [](const glm::dvec3& p) { return std::abs(p.x) + std::abs(p.y) + std::abs(p.z); };
  const glm::dvec3& nearest = *std::min_element(points.begin(), points.end(),
                                                [&distance](const glm::dvec3& a, const glm::dvec3& b)
                                                { return distance(a) < distance(b); });
  return {normal, -glm::dot(normal, nearest)};
}

std::size_t SEDGeometry::getMemorySize() const
{
  return bytesOf(this->positions) + bytesOf(this->triangles) + bytesOf(this->inputOrder) +
         bytesOf(this->reversed.getWords()) + bytesOf(this->inputReversed.getWords()) +
         bytesOf(this->copies.getWords()) + bytesOf(this->planeBlocks) + this->edgeTable.getMemorySize() + this->clusterTree.getMemorySize() +
         this->prepared->getMemorySize();
}

} // namespace shadow
