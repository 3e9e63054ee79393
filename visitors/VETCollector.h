#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "NodeVisitor.h"
#include "SEDGeode.h"
#include "VETCollection.h"

namespace shadow
{

/// Gathers vertices, edges and triangles of a subgraph into one set of arrays, and keeps these up to date at
/// the least cost.
///
/// @par Source  Shi 2006, chapter 4.3.2
class VETCollector : private NodeVisitor
{
public:
  /// What of the collection differs from before.
  enum class Change
  {
    Nothing,
    Positions, ///< vertices of some ranges moved: their positionRevision rose. A geometry counts as moved,
               ///< whatever node holds it, where isSameMeshMoved(); corners may then have changed places
    Everything ///< topologyRevision and all revisions of ranges rose
  };

  /// Walks the visible part of the graph. Geodes under a transform that flattens are left out, as they have
  /// no inside to cast from.
  ///
  /// @return  what changed since the last call; Everything the first time
  /// @throws std::length_error  when there are more vertices, triangles or edges than a GL int can count; the
  ///                            collection is then empty
  /// @par Cost  O(paths) when nothing changed; O(vertices) of what moved; O(triangles) of a mesh that was
  ///            built anew; else O(triangles) of all
  Change collect(Node& root);

  const VETCollection& getCollection() const { return this->collection; }

private:
  using NodeVisitor::apply;
  void apply(SEDGeode& geode) override;

  bool hasSameTopology() const;
  Change gatherEverything();
  Change gatherMoved();
  SceneFrame chooseFrame(bool mayKeep) const;

  VETCollection collection;
  std::vector<VETRange> found;                 ///< what the walk met; without revisions
  std::map<NodePath, std::size_t> placeOfPath; ///< in found
  std::size_t foundVertices = 0;
  std::size_t foundTriangles = 0;
  std::size_t foundEdges = 0;
};

} // namespace shadow
