#pragma once

#include <algorithm>

#include "NodeVisitor.h"
#include "SEDGeode.h"
#include "View.h"

namespace shadow
{

/// Asks how far before and behind the near plane the geometry reaches: a parallel view stores depth linearly between.
class DepthBoundsVisitor : public NodeVisitor
{
public:
  explicit DepthBoundsVisitor(const View& theView) : view(theView) {}

  using NodeVisitor::apply;
  void apply(SEDGeode& geode) override
  {
    for (const glm::dvec3& corner : worldCorners(geode.getGeometry(), this->getModelToWorld()))
    {
      const double depth = glm::dot(this->view.viewDepth, glm::dvec4(corner, 1.0));
      this->nearest = std::min(this->nearest, depth);
      this->farthest = std::max(this->farthest, depth);
    }
  }

  /// Distances in front of the near plane, with a margin so that no geometry lies on either end.
  double getNearest() const { return this->nearest - this->getMargin(); }
  double getFarthest() const { return this->farthest + this->getMargin(); }

private:
  double getMargin() const { return 1e-3 * std::max(this->farthest - this->nearest, 1e-300); }

  const View& view;
  double nearest = 0.0;
  double farthest = 0.0;
};

} // namespace shadow
