#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ExactOrientation.h"
#include "ShadowVolume.h"

namespace shadow
{

namespace
{

/// How far outside its bounding box a point light has to be to count as outside, relative to the box.
constexpr double boxMargin = 1e-6;

bool isInsideBox(const SEDGeometry& geometry, const glm::dvec3& lightMC)
{
  const glm::dvec3& lower = geometry.getLowerBound();
  const glm::dvec3& upper = geometry.getUpperBound();
  const double margin = boxMargin * glm::length(upper - lower);
  for (int axis = 0; axis < 3; ++axis)
  {
    // Written so that a light that is not a number is not outside either.
    if (lightMC[axis] < lower[axis] - margin || lightMC[axis] > upper[axis] + margin)
    {
      return false;
    }
  }
  return true;
}

/// Sign of a plane's value at the light from the corners.
///
/// @return  for the raster order of the triangle
int resolve(const SEDGeometry& geometry, std::uint32_t triangle, const glm::dvec4& lightMC)
{
  const std::array<std::uint32_t, 3>& corners = geometry.getTriangles()[triangle];
  const std::vector<glm::vec3>& positions = geometry.getPositions();
  return orientation(positions[corners[0]], positions[corners[1]], positions[corners[2]], lightMC);
}

/// Evaluates the planes of one word of triangles. Kept apart from the decisions, so that compilers vectorise
/// it.
void evaluatePlanes(const TrianglePlane* planes, std::size_t count, const glm::dvec4& lightMC, double* values)
{
  const double x = lightMC.x;
  const double y = lightMC.y;
  const double z = lightMC.z;
  const double w = lightMC.w;
  for (std::size_t index = 0; index < count; ++index)
  {
    const TrianglePlane& plane = planes[index];
    values[index] = (plane.normal.x * x + plane.normal.y * y) + (plane.normal.z * z + plane.offset * w);
  }
}

/// Facing of the triangles whose planes decide it.
///
/// @return  the triangles whose value is within rounding of zero
std::vector<std::uint32_t> decideByPlanes(const SEDGeometry& geometry, const glm::dvec4& lightMC,
                                          LightFacing& facing)
{
  const std::vector<TrianglePlane>& planes = geometry.getPlanes();
  const double directionReach = std::abs(lightMC.x) + std::abs(lightMC.y) + std::abs(lightMC.z);
  std::vector<std::uint32_t> doubtful;
  std::array<double, 64> values{};
  for (std::size_t word = 0; word < geometry.getPlaneErrors().size(); ++word)
  {
    const PlaneError& error = geometry.getPlaneErrors()[word];
    const double bound = error.direction * directionReach + error.position * std::abs(lightMC.w);
    const std::size_t count = std::min<std::size_t>(64, planes.size() - 64 * word);
    evaluatePlanes(&planes[64 * word], count, lightMC, values.data());
    std::uint64_t towards = 0;
    std::uint64_t away = 0;
    for (std::size_t bit = 0; bit < count; ++bit)
    {
      towards |= std::uint64_t{values[bit] > bound} << bit;
      away |= std::uint64_t{values[bit] < -bound} << bit;
    }
    facing.towards.data()[word] = towards;
    facing.away.data()[word] = away;
    const std::uint64_t wanted = count == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
    if ((towards | away) != wanted)
    {
      for (std::size_t bit = 0; bit < count; ++bit)
      {
        if (!(((towards | away) >> bit) & 1u))
        {
          doubtful.push_back(static_cast<std::uint32_t>(64 * word + bit));
        }
      }
    }
  }
  return doubtful;
}

/// Does a corner coincide with the light, as seen by whoever extrudes the triangle in single precision?
bool touches(const SEDGeometry& geometry, const std::array<std::uint32_t, 3>& triangle,
             const glm::vec3& lightMC)
{
  return std::any_of(triangle.begin(), triangle.end(),
                     [&geometry, &lightMC](std::uint32_t vertex)
                     { return geometry.getPositions()[vertex] == lightMC; });
}

} // namespace

LightFacing computeFacing(const SEDGeometry& geometry, const glm::dvec4& lightMC)
{
  LightFacing facing;
  facing.towards.assign(geometry.getTriangles().size());
  facing.away.assign(geometry.getTriangles().size());
  if (!std::isfinite(lightMC.x) || !std::isfinite(lightMC.y) || !std::isfinite(lightMC.z) ||
      !std::isfinite(lightMC.w))
  {
    return facing;
  }

  for (const std::uint32_t triangle : decideByPlanes(geometry, lightMC, facing))
  {
    const int rasterSign = resolve(geometry, triangle, lightMC);
    const int sign = geometry.getReversed().test(triangle) ? -rasterSign : rasterSign;
    if (sign != 0)
    {
      (sign > 0 ? facing.towards : facing.away).set(triangle);
    }
  }
  clearTouching(geometry, lightMC, facing);
  return facing;
}

void clearTouching(const SEDGeometry& geometry, const glm::dvec4& lightMC, LightFacing& facing)
{
  if (lightMC.w == 0.0 || !isInsideBox(geometry, glm::dvec3(lightMC)))
  {
    return;
  }
  const glm::vec3 light(lightMC);
  const std::vector<glm::vec3>& positions = geometry.getPositions();
  if (std::find(positions.begin(), positions.end(), light) == positions.end())
  {
    return;
  }
  for (std::size_t triangle = 0; triangle < geometry.getTriangles().size(); ++triangle)
  {
    if (touches(geometry, geometry.getTriangles()[triangle], light))
    {
      const std::uint64_t others = ~(std::uint64_t{1} << (triangle & 63));
      facing.towards.data()[triangle >> 6] &= others;
      facing.away.data()[triangle >> 6] &= others;
    }
  }
}

Casting chooseCasting(const SEDGeometry& geometry, const glm::dvec4& lightMC)
{
  const bool outside = lightMC.w == 0.0 || !isInsideBox(geometry, glm::dvec3(lightMC));
  return geometry.isClosed() && outside ? Casting::LightFacing : Casting::EveryTriangle;
}

} // namespace shadow
