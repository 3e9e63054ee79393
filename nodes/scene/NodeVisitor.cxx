#include "NodeVisitor.h"

namespace shadow
{

void NodeVisitor::traverse(Group& group)
{
  for (const std::shared_ptr<Node>& child : group.getChildren())
  {
    child->accept(*this);
  }
}

void NodeVisitor::apply(Transform& transform)
{
  const glm::dmat4 parent = this->modelToWorld;
  this->modelToWorld = parent * transform.matrix;
  this->traverse(transform);
  this->modelToWorld = parent;
}

} // namespace shadow
