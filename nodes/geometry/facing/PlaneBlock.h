#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <glm/glm.hpp>

namespace shadow
{

/// Planes of the 64 triangles of one word of FacingBits: dot((x, y, z), p) + offset > 0 in front of them, for
/// p relative to the geometry's origin and in units of its reach.
///
/// The normals have unit length, so that those of a smooth patch are nearly equal, and |offset| is below 1;
/// all four are whole numbers of 1 / unitsInOne. A triangle whose plane is not known as well as that, one
/// without area above all, and one that is not there have a plane of zeros: it decides nothing.
///
/// So few digits leave more triangles to be decided from their corners, a few in a hundred thousand of a
/// smooth mesh. But deciding the others takes no longer than reading their planes: half the bytes are half
/// the time.
///
/// The planes of a quarter, 16 triangles, fill two cache lines.
struct alignas(64) PlaneBlock
{
  static constexpr std::size_t triangles = 64;
  static constexpr std::size_t quarter = 16; ///< triangles
  static constexpr double unitsInOne = 32767.0;

  /// Where the plane of a triangle stands: in its quarter, and there such that comparing vectors of eight and
  /// packing the results, as x86 does within halves of vectors, gives 16 bits in their order.
  static constexpr std::size_t slotOf(std::size_t bit)
  {
    return quarter * (bit / quarter) + 8 * (bit % 8 / 4) + 4 * (bit % quarter / 8) + bit % 4;
  }

  /// Rounds a plane to whole units. @pre the normal has unit length, |distance| <= 1
  void set(std::size_t bit, const glm::dvec3& normal, double distance)
  {
    const auto toUnits = [](double value)
    { return static_cast<std::int16_t>(std::lround(value * unitsInOne)); };
    const std::size_t slot = slotOf(bit);
    this->xy[slot] = {toUnits(normal.x), toUnits(normal.y)};
    this->zOffset[slot] = {toUnits(normal.z), toUnits(distance)};
  }

  /// The plane as it was rounded: normal and offset, in units.
  glm::ivec4 getUnits(std::size_t bit) const
  {
    const std::size_t slot = slotOf(bit);
    return {this->xy[slot][0], this->xy[slot][1], this->zOffset[slot][0], this->zOffset[slot][1]};
  }

  glm::dvec4 get(std::size_t bit) const { return glm::dvec4(this->getUnits(bit)) / unitsInOne; }

  using Pair = std::array<std::int16_t, 2>;
  std::array<Pair, triangles> xy{};
  std::array<Pair, triangles> zOffset{};
};

} // namespace shadow
