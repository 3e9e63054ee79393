#pragma once

#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "Node.h"

namespace shadow
{

class SEDGeode;

/// The nodes from the root to the one that is visited.
using NodePath = std::vector<const Node*>;

/// What messages call the end of a path: a shared geode goes by the name of what places it.
std::string describePath(const NodePath& path);

/// Walks a scene graph and asks one question of each node. Invisible subgraphs are not entered.
class NodeVisitor
{
public:
  virtual ~NodeVisitor() = default;

  virtual void apply(Group& group) { this->traverse(group); }
  virtual void apply(Transform& transform);
  virtual void apply(SEDGeode&) {}

  /// Keeps the path while @p visit runs. Called by Node::accept().
  template <class Visit>
  void enter(const Node& node, Visit&& visit)
  {
    if (!node.visible)
    {
      return;
    }
    const bool parentDrawn = this->drawn;
    const bool parentCasts = this->casting;
    const FaceCulling parentCulling = this->faceCulling;
    this->drawn = parentDrawn && node.drawn;
    this->casting = parentCasts && node.casting;
    this->faceCulling = node.faceCulling == FaceCulling::None ? parentCulling : node.faceCulling;
    this->nodePath.push_back(&node);
    visit();
    this->nodePath.pop_back();
    this->drawn = parentDrawn;
    this->casting = parentCasts;
    this->faceCulling = parentCulling;
  }

protected:
  void traverse(Group& group);

  /// Model to world space of the node that is visited.
  const glm::dmat4& getModelToWorld() const { return this->modelToWorld; }
  const NodePath& getPath() const { return this->nodePath; }
  bool isDrawn() const { return this->drawn; }
  bool isCasting() const { return this->casting; }
  FaceCulling getFaceCulling() const { return this->faceCulling; }

private:
  NodePath nodePath;
  glm::dmat4 modelToWorld{1.0};
  bool drawn = true;
  bool casting = true;
  FaceCulling faceCulling = FaceCulling::None;
};

} // namespace shadow
