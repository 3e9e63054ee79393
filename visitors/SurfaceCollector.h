#pragma once

#include <string>
#include <utility>
#include <vector>

#include "LargeMeshVisitor.h"
#include "NodeVisitor.h"
#include "SEDGeode.h"

namespace shadow
{

/// All that a shadow mask depends on of a path of the scene graph; the same when equal.
struct CollectedSurface
{
  ShownSurface shown;
  bool drawn = true;
  bool casting = true;
  std::string name; ///< what messages call it

  bool operator==(const CollectedSurface& other) const
  {
    return this->shown == other.shown && this->drawn == other.drawn && this->casting == other.casting &&
           this->name == other.name;
  }
};

/// Lists what a scene graph shows and what casts in it, in the order in which it is drawn. Of all that it meets
/// it has the SEDGeode keep what it has for the path.
class SurfaceCollector : public NodeVisitor
{
public:
  using NodeVisitor::apply;
  void apply(SEDGeode& geode) override
  {
    geode.getPathState(this->getPath());
    this->surfaces.push_back(
        {{this->getPath(), geode.getSharedGeometry(), this->getModelToWorld(), this->getFaceCulling()},
         this->isDrawn(),
         this->isCasting(),
         describePath(this->getPath())});
  }

  std::vector<CollectedSurface> take() { return std::move(this->surfaces); }

private:
  std::vector<CollectedSurface> surfaces;
};

} // namespace shadow
