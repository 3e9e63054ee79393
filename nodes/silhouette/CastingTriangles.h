#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

#include "FacingBits.h"
#include "SEDGeometry.h"
#include "ShadowVolume.h"

namespace shadow
{

/// Calls visit(triangle) for every bit that is set.
///
/// @param among  only triangles whose bit is set here as well; null: all
/// @par Cost  O(triangles / 64 + set bits)
template <class Visit>
void forEachTriangle(const FacingBits& bits, const FacingBits* among, Visit&& visit)
{
  for (std::size_t word = 0; word < bits.getWords().size(); ++word)
  {
    std::uint64_t left = bits.getWords()[word];
    left &= among != nullptr ? among->getWords()[word] : ~std::uint64_t{0};
    for (; left != 0; left &= left - 1)
    {
      visit(static_cast<std::uint32_t>(64 * word + findLowestBit(left)));
    }
  }
}

/// Corners of a triangle, counter-clockwise seen from its front.
///
/// @param turned  seen from its back instead
inline std::array<std::uint32_t, 3> getTurnedCorners(const SEDGeometry& geometry, std::uint32_t triangle,
                                                     bool turned)
{
  std::array<std::uint32_t, 3> corners = geometry.getTriangles()[triangle];
  if (geometry.getReversed().test(triangle) != turned)
  {
    std::swap(corners[1], corners[2]);
  }
  return corners;
}

/// 1 when a triangle casts as it is oriented, -1 when it casts turned over, 0 when it does not cast.
inline int getCastingSign(const LightFacing& facing, Casting casting, std::uint32_t triangle)
{
  const int sign = facing.towards.test(triangle) ? 1 : 0;
  return casting == Casting::LightFacing ? sign : sign - (facing.away.test(triangle) ? 1 : 0);
}

/// Calls visit(a, b, c) with the corners of every casting triangle, counter-clockwise seen from the light.
///
/// @param among  only these triangles; null: all
template <class Visit>
void forEachCastingTriangle(const SEDGeometry& geometry, const LightFacing& facing, Casting casting,
                            const FacingBits* among, Visit&& visit)
{
  const auto visitTurned = [&](std::uint32_t triangle, bool turned)
  {
    const auto [a, b, c] = getTurnedCorners(geometry, triangle, turned);
    visit(a, b, c);
  };
  forEachTriangle(facing.towards, among, [&](std::uint32_t triangle) { visitTurned(triangle, false); });
  if (casting == Casting::EveryTriangle)
  {
    forEachTriangle(facing.away, among, [&](std::uint32_t triangle) { visitTurned(triangle, true); });
  }
}

/// Adds a side of a triangle to a silhouette, unless @p runs is 0.
///
/// @param runs  how often more casting triangles, each turned to the light, run through the side as the
///              oriented triangle does than against it
inline void addSide(const SEDGeometry& geometry, std::uint32_t triangle, std::uint32_t side, int runs,
                    std::vector<SilhouetteEdge>& silhouette)
{
  if (runs != 0)
  {
    // Looked up, as which way an edge runs is nothing that a processor could foresee.
    const std::array<std::uint32_t, 2> ends = geometry.getSide(triangle, side);
    const std::size_t from = runs < 0 ? 1 : 0;
    // Stored number by number: an edge that was put together in memory would have to wait for its parts.
    SilhouetteEdge& edge = silhouette.emplace_back();
    edge.from = ends[from];
    edge.to = ends[1 - from];
    edge.multiplicity = static_cast<std::uint32_t>(std::abs(runs));
  }
}

} // namespace shadow
