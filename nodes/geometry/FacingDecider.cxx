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

bool touchesLight(const SEDGeometry& geometry, std::uint32_t triangle, const glm::vec3& lightMC)
{
  const std::array<std::uint32_t, 3>& corners = geometry.getTriangles()[triangle];
  return std::any_of(corners.begin(), corners.end(),
                     [&geometry, &lightMC](std::uint32_t vertex)
                     { return geometry.getPositions()[vertex] == lightMC; });
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
  if (this->lightMC.w != 0.0 && touchesLight(this->geometry, triangle, glm::vec3(this->lightMC)))
  {
    return 0;
  }
  const std::array<std::uint32_t, 3>& corners = this->geometry.getTriangles()[triangle];
  const std::vector<glm::vec3>& positions = this->geometry.getPositions();
  const int rasterSign =
      orientation(positions[corners[0]], positions[corners[1]], positions[corners[2]], this->lightMC);
  return this->geometry.getReversed().test(triangle) ? -rasterSign : rasterSign;
}

} // namespace shadow
