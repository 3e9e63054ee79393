#pragma once

#include <algorithm>
#include <limits>

#include "NodeVisitor.h"
#include "SEDGeode.h"
#include "View.h"

namespace shadow
{

/// What a scene graph covers.
struct SceneBounds
{
  glm::dvec3 lowerWC{std::numeric_limits<double>::max()};
  glm::dvec3 upperWC{std::numeric_limits<double>::lowest()};
  double nearest = 0.0; ///< distances in front of the view's near plane
  double farthest = 0.0;

  bool isEmpty() const { return this->lowerWC.x > this->upperWC.x; }
};

/// Asks how far the geometry reaches, in world space and along the view.
class SceneBoundsVisitor : public NodeVisitor
{
public:
  explicit SceneBoundsVisitor(const View& theView) : view(theView) {}

  using NodeVisitor::apply;
  void apply(SEDGeode& geode) override
  {
    for (const glm::dvec3& corner : worldCorners(geode.getGeometry(), this->getModelToWorld()))
    {
      this->bounds.lowerWC = glm::min(this->bounds.lowerWC, corner);
      this->bounds.upperWC = glm::max(this->bounds.upperWC, corner);
      const double depth = glm::dot(this->view.viewDepth, glm::dvec4(corner, 1.0));
      this->bounds.nearest = std::min(this->bounds.nearest, depth);
      this->bounds.farthest = std::max(this->bounds.farthest, depth);
    }
  }

  const SceneBounds& getBounds() const { return this->bounds; }

private:
  const View& view;
  SceneBounds bounds;
};

} // namespace shadow
