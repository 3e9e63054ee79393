#include "NodeVisitor.h"

#include <algorithm>

namespace shadow
{

std::string describePath(const NodePath& path)
{
  const auto named =
      std::find_if(path.rbegin(), path.rend(), [](const Node* node) { return !node->name.empty(); });
  return named != path.rend() ? (*named)->name : "";
}

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
