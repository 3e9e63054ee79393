#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "SEDGeometry.h"
#include "ShadowVolume.h"

namespace shadow
{

/// Triangles that a point light is very close to, and what their shadow volumes need besides.
///
/// Seen from a light just in front of a triangle, the triangle fills nearly half of all directions. The rays
/// through its corners then lie nearly in one plane, and whether the half on one side of that is in shadow or
/// the half on the other would be up to their rounding; so would be which way a side runs where the light is
/// just off an edge. So the far copy of such a triangle is a fan around one more ray, away from the light and
/// across the triangle, and sides of edges that pass the light get one more ray, through the point of the edge
/// next to it. No three rays that span a face then lie nearly in one plane unless the face is a sliver, of which
/// no side matters.

/// Whether a triangle can be close to the light at all, by the bounding box.
/// @param lightMC  relative to the geometry's origin
bool mayHaveCloseTriangles(const SEDGeometry& geometry, const glm::dvec4& lightMC);

/// The triangles that cast and are close to the light; rising. None for a directional light.
///
/// @param facing   as computeFacing() gives it, or a part of that
/// @param lightMC  relative to the geometry's origin
/// @post  every casting triangle that has an edge which passes the light is among them
/// @par Cost  O(1) when the light is outside of the bounding box, else O(triangles)
std::vector<std::uint32_t> findCloseTriangles(const SEDGeometry& geometry, const LightFacing& facing,
                                              Casting casting, const glm::dvec4& lightMC);

/// Builds the ClosePart of a shadow volume.
class ClosePartBuilder
{
public:
  /// @param lightMC  position relative to the geometry's origin
  ClosePartBuilder(const SEDGeometry& theGeometry, const glm::dvec3& theLightMC, ShadowVolume::ClosePart& thePart)
      : geometry(theGeometry), lightMC(theLightMC), part(thePart)
  {
  }

  /// Whether the ends of an edge are seen from the light in opposite directions, up to half a degree.
  bool passesLight(std::uint32_t from, std::uint32_t to) const;

  /// The side of an edge that passes the light.
  void addSide(const SilhouetteEdge& edge);

  /// The far copy of a casting triangle, looking away from the light.
  /// @param turned  it casts turned over
  void addDarkFan(std::uint32_t triangle, bool turned);

private:
  glm::dvec3 getRay(std::uint32_t vertex) const;
  std::uint32_t addCopy(std::uint32_t vertex, bool isFar);
  std::uint32_t addRay(const glm::dvec3& ray);
  std::uint32_t addRayBetween(std::uint32_t from, std::uint32_t to);

  const SEDGeometry& geometry;
  const glm::dvec3 lightMC;
  ShadowVolume::ClosePart& part;
};

} // namespace shadow
