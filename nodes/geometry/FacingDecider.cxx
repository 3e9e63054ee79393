#include "FacingDecider.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ExactOrientation.h"

namespace shadow
{

ScaledLight scaleLight(const glm::dvec4& lightMC, double reach)
{
  const glm::dvec4 inReach(glm::dvec3(lightMC), lightMC.w * reach);
  const glm::dvec4 size = glm::abs(inReach);
  const double largest = std::max({size.x, size.y, size.z, size.w});
  const double sum = size.x + size.y + size.z + size.w;
  if (!(largest > 0.0) || !std::isfinite(sum))
  {
    return {};
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  const double factor = std::ldexp(1.0, -exponent);
  const glm::dvec4 scaled = inReach * factor;
  // Positions so small that single precision has no digits for them are where they are only roughly.
  const double touching = lightMC.w != 0.0 ? 0x1p-146 * factor : 0.0;
  const double bound = 8.0 * 0x1p-24 * sum * factor + 0x1p-100 + touching;
  return {static_cast<float>(scaled.x), static_cast<float>(scaled.y), static_cast<float>(scaled.z),
          static_cast<float>(scaled.w), static_cast<float>(bound)};
}

FacingDecider::FacingDecider(const SEDGeometry& theGeometry, const glm::dvec4& theLightMC, InstructionSet set)
    : geometry(theGeometry), lightMC(theLightMC), light(scaleLight(theLightMC, theGeometry.getReach())),
      comparePlanes(getPlaneKernel(set))
{
}

void FacingDecider::decide(std::size_t firstWord, std::size_t endWord, LightFacing& facing) const
{
  std::uint64_t* towards = facing.towards.data();
  std::uint64_t* away = facing.away.data();
  this->comparePlanes(this->geometry.getPlaneBlocks().data() + firstWord, endWord - firstWord, this->light,
                      towards + firstWord, away + firstWord);
  const std::size_t triangles = this->geometry.getTriangles().size();
  for (std::size_t word = firstWord; word < endWord; ++word)
  {
    std::uint64_t doubtful = ~(towards[word] | away[word]);
    for (std::size_t bit = 0; doubtful != 0; ++bit, doubtful >>= 1)
    {
      const std::size_t triangle = 64 * word + bit;
      if ((doubtful & 1u) == 0 || triangle >= triangles)
      {
        continue;
      }
      const int sign = this->resolve(static_cast<std::uint32_t>(triangle));
      towards[word] |= std::uint64_t{sign > 0} << bit;
      away[word] |= std::uint64_t{sign < 0} << bit;
    }
  }
}

/// The exact sign: by a sharper filter in double precision, then by exact arithmetic.
int FacingDecider::resolve(std::uint32_t triangle) const
{
  // A corner at the light has no direction to be extruded in, so its triangle must not cast: it counts as
  // having the light in its plane, which exactly it does, but for the light's rounding to single precision.
  if (this->lightMC.w != 0.0 && this->touchesLight(triangle))
  {
    return 0;
  }
  const std::array<std::uint32_t, 3>& corners = this->geometry.getTriangles()[triangle];
  const std::vector<glm::vec3>& positions = this->geometry.getPositions();
  const int orientation = this->geometry.getReversed().test(triangle) ? -1 : 1;
  const glm::dvec3 a(positions[corners[0]]);
  const glm::dvec3 u = glm::dvec3(positions[corners[1]]) - a;
  const glm::dvec3 v = glm::dvec3(positions[corners[2]]) - a;
  const glm::dvec3 arm = glm::dvec3(this->lightMC) - this->lightMC.w * a;
  const glm::dvec3 products = glm::abs(glm::dvec3(u.y * v.z, u.z * v.x, u.x * v.y)) +
                              glm::abs(glm::dvec3(u.z * v.y, u.x * v.z, u.y * v.x));
  const double value = glm::dot(glm::cross(u, v), arm);
  // With eps = 2^-53: 4 eps from the cross product, 2 from the arm, 3 from the dot product; 12 leaves room.
  const double bound =
      12.0 * 0x1p-53 *
      glm::dot(products, glm::abs(glm::dvec3(this->lightMC)) + glm::abs(this->lightMC.w * a));
  if (std::abs(value) > bound)
  {
    return value > 0.0 ? orientation : -orientation;
  }
  return orientation *
         exactOrientation(positions[corners[0]], positions[corners[1]], positions[corners[2]], this->lightMC);
}

/// Does a corner coincide with the light, as seen by whoever extrudes the triangle in single precision?
bool FacingDecider::touchesLight(std::uint32_t triangle) const
{
  const std::array<std::uint32_t, 3>& corners = this->geometry.getTriangles()[triangle];
  return std::any_of(corners.begin(), corners.end(),
                     [this](std::uint32_t vertex)
                     { return this->geometry.getPositions()[vertex] == glm::vec3(this->lightMC); });
}

} // namespace shadow
