#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

namespace shadow
{

class NodeVisitor;

/// Which sides of its triangles a subgraph does not show.
enum class FaceCulling
{
  None,
  Back,
  Front
};

/// A part of the scene graph. Nodes may have several parents; what depends on the way down to a node is kept
/// by path.
class Node
{
public:
  Node() = default;
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;
  virtual ~Node() = default;

  /// Calls the visitor's apply() for the node's own type.
  virtual void accept(NodeVisitor& visitor) = 0;

  std::string name;                            ///< for messages
  bool visible = true;                         ///< false: the subgraph is neither drawn nor casts
  bool drawn = true;                           ///< false: the subgraph casts but no pixel shows it, nor does
                                               ///< it hide anything
  bool casting = true;                         ///< false: the subgraph is drawn but casts nothing, or, for
                                               ///< outlines, has none
  FaceCulling faceCulling = FaceCulling::None; ///< what the subgraph's surfaces hide from the camera
};

/// An inner node.
class Group : public Node
{
public:
  void accept(NodeVisitor& visitor) override;

  void addChild(std::shared_ptr<Node> child) { this->children.push_back(std::move(child)); }
  void clearChildren() { this->children.clear(); }
  const std::vector<std::shared_ptr<Node>>& getChildren() const { return this->children; }

private:
  std::vector<std::shared_ptr<Node>> children;
};

/// An inner node that places its children: parent = matrix * child, column vectors, any affine matrix.
class Transform : public Group
{
public:
  void accept(NodeVisitor& visitor) override;

  glm::dmat4 matrix{1.0};
};

} // namespace shadow
