#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "FacingBits.h"
#include "SEDGeometry.h"

namespace shadow
{

/// Some triangles, as the bits of one word of FacingBits.
struct TriangleWord
{
  std::uint32_t word; ///< holds triangles 64 * word to 64 * word + 63
  std::uint64_t mask;
};

/// Connected triangles in one plane that face the same way, as one polygon: two triangles or more, with any
/// number of holes.
struct FlatPolygon
{
  std::uint32_t representative; ///< the triangle whose plane the others were held against
  std::uint32_t triangleCount;
  std::uint32_t borderBegin; ///< into FlatRegions::border
  std::uint32_t borderEnd;
  std::uint32_t wordsBegin; ///< into FlatRegions::words
  std::uint32_t wordsEnd;
};

/// A mesh's flat regions. Made by findFlatRegions().
struct FlatRegions
{
  std::vector<FlatPolygon> polygons;
  std::vector<std::array<std::uint32_t, 2>>
      border;                      ///< vertices from, to: edges of the mesh, wound as the polygon's triangles
                                   ///< wind them; a polygon's outer border and those of its holes
  std::vector<TriangleWord> words; ///< which triangles a polygon is made of
  FacingBits alone;                ///< bit t: triangle t is part of no polygon

  /// Polygons and single triangles together.
  std::size_t getRegionCount() const { return this->polygons.size() + this->alone.countSet(); }

  std::size_t getMemorySize() const;
};

/// Merges coplanar neighbours into polygons.
///
/// Only edges of the adjacency are merged over, so a region ends at borders and where a non-manifold edge was
/// split. Triangles without area are in no plane and stay alone.
///
/// @param toleranceDegrees  0: triangles are merged that lie exactly in one plane, which every light sees
///                          from the same side. Above, up to below 90: those whose normals are within this
///                          angle of the representative's, so that what grows from it cannot drift
/// @par Cost    O(triangles * log(triangles)), below 0.5 microseconds a triangle; 90 bytes a triangle while
/// it
///              works
/// @par Source  Kolivand & Sunar 2011, "Hybrid Silhouette Detection for Real-Time Shadow Volume"
FlatRegions findFlatRegions(const SEDGeometry& geometry, double toleranceDegrees = 0.0);

} // namespace shadow
