#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "SEDGeometry.h"
#include "ShadowVolume.h"

namespace shadow
{

struct DifferingEdge;

/// Finds silhouette edges by comparing the bits of the two triangles of each edge; see
/// SilhouetteFinder::find(). May be used by several threads at once.
///
/// @par Cost  reads 2 bytes and two bits an inner edge of a word, 5 bytes and two bits an outer one, see
/// EdgeTable
class EdgeScan
{
public:
  EdgeScan(const SEDGeometry& theGeometry, const LightFacing& theFacing, Casting theCasting);

  /// Adds the silhouette edges of the words [firstWord, endWord) that are no borders.
  void addWords(std::size_t firstWord, std::size_t endWord, std::vector<SilhouetteEdge>& silhouette) const;

  /// The same for words that stand in a list.
  void addWords(const std::vector<std::uint32_t>& words, std::vector<SilhouetteEdge>& silhouette) const;

  /// Adds the borders that are silhouette edges.
  void addBorders(std::vector<SilhouetteEdge>& silhouette) const;

private:
  class Batch;

  int getSign(std::uint32_t triangle) const;
  void prefetchSides(const DifferingEdge* begin, const DifferingEdge* end) const;
  void addSides(const DifferingEdge* begin, const DifferingEdge* end,
                std::vector<SilhouetteEdge>& silhouette) const;

  const SEDGeometry& geometry;
  const LightFacing& facing;
  Casting casting;
  const std::uint64_t* towards;
  const std::uint64_t* away; ///< null where comparing towards is enough
};

} // namespace shadow
