#pragma once

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include "NodeVisitor.h"
#include "SEDGeode.h"
#include "SurfaceBatch.h"

namespace shadow
{

/// Finds the small meshes that are to be drawn together, and marks their paths.
///
/// @pre  the CasterCuller has been here before
class BatchCollector : private NodeVisitor
{
public:
  static constexpr std::size_t fewest = 2;

  /// Triangles of a mesh at most: what a call costs beside its triangles is what some 50 of them cost.
  static constexpr std::size_t largestMesh = 512;

  /// Triangles in all at most, as each path has a copy.
  static constexpr std::size_t mostTriangles = std::size_t{1} << 21;

  /// @param mostSurfaces  at most; 0: none
  /// @return those of the visible part of the graph, in the order of a walk; none where there are fewer than fewest
  /// @post   PathState::batched of every path under @p root
  std::vector<BatchedSurface> collect(Node& root, std::size_t mostSurfaces);

  /// Whether a DrawVisitor has anything to draw, which is true before the first collect().
  bool hasSurfacesAlone() const { return this->surfacesAlone; }
  bool hasVolumesAlone(int light, StencilCount count) const
  {
    return !this->collected || this->volumesAlone.count({light, count}) != 0;
  }

private:
  void noteAlone(const PathState& path);
  using NodeVisitor::apply;
  void apply(SEDGeode& geode) override;

  std::vector<BatchedSurface> found;
  std::size_t most = 0;
  std::size_t triangles = 0;
  bool collected = false;
  bool surfacesAlone = true;
  std::set<std::pair<int, StencilCount>> volumesAlone; ///< by Light::index
};

} // namespace shadow
