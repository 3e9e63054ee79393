#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "SEDGeometry.h"
#include "ShadowVolume.h"

namespace shadow::test
{

/// How often more each directed edge is run through forwards than backwards; edges that cancel are left out.
class EdgeBalance
{
public:
  /// Adds one run from vertex @p from to vertex @p to, @p times over (negative: backwards).
  void add(std::uint32_t from, std::uint32_t to, int times = 1);

  void addTriangle(const std::array<std::uint32_t, 3>& triangle, int times = 1);

  bool isClosed() const { return this->sums.empty(); }
  const std::map<std::pair<std::uint32_t, std::uint32_t>, int>& get() const { return this->sums; }

private:
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sums;
};

/// For each vertex the first one at the same position: undoes the splitting of vertices.
std::vector<std::uint32_t> findFirstAtPosition(const SEDGeometry& geometry);

/// All faces of a volume wound counter-clockwise from outside. The far copies of a directional light's volume
/// become one index, and its sides stay single triangles.
///
/// @param geometry  what the volume is of: vertices at one position count as one, as do rays that are equal
EdgeBalance balanceVolume(const SEDGeometry& geometry, const ShadowVolume& volume, bool directional);

/// Does the triangle cross the open segment?
///
/// @return  1 when the segment leaves the side that sees the corners counter-clockwise, -1 the other way, 0
/// for a miss
int crossSegment(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& start, const glm::dvec3& end);

/// Corners of an oriented triangle.
std::array<glm::dvec3, 3> getCorners(const SEDGeometry& geometry, std::size_t triangle);

/// Where the segment from a point to the light ends: at a point light, or far along the direction.
glm::dvec3 getLightEnd(const glm::dvec3& point, const glm::dvec4& lightMC);

/// Triangles between a point and the light, counted one by one.
///
/// @param onlyTowards  null, or the facing of which only the triangles turned to the light count
std::size_t countBlockers(const SEDGeometry& geometry, const glm::dvec3& point, const glm::dvec4& lightMC,
                          const LightFacing* onlyTowards = nullptr);

/// How often the volume's faces enclose a point, by counting crossings on the way to @p outside, which must
/// be a point in the light. Far copies are placed at a finite distance, far beyond the meshes.
int countEnclosing(const SEDGeometry& geometry, const ShadowVolume& volume, const glm::dvec4& lightMC,
                   const glm::dvec3& point, const glm::dvec3& outside);

} // namespace shadow::test
