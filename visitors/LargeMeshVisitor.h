#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "NodeVisitor.h"
#include "SEDGeode.h"

namespace shadow
{

/// A path of the scene graph with many triangles.
struct LargeMesh
{
  NodePath path;
  PathState* state = nullptr;
  std::size_t triangles = 0;
  bool inwards = false;                 ///< the input is wound so that its fronts look inwards
  FaceCulling back = FaceCulling::Back; ///< what VTK has to cull to leave out what looks inwards
};

/// What the pre-pass shows of a path; the same surfaces when equal.
struct ShownSurface
{
  NodePath path;
  std::weak_ptr<const SEDGeometry> geometry;
  glm::dmat4 modelToWorld{1.0};
  FaceCulling culling = FaceCulling::None;

  bool operator==(const ShownSurface& other) const;
};

/// Asks which surfaces are in view, and which of them belong to meshes that are large and drawn with both
/// sides. Takes marks off all paths.
class LargeMeshVisitor : public NodeVisitor
{
public:
  /// @param least         triangles that make a mesh a large one
  /// @param mirrored      see View::mirrored
  LargeMeshVisitor(std::size_t least, bool mirrored) : leastTriangles(least), viewMirrored(mirrored) {}

  using NodeVisitor::apply;
  void apply(SEDGeode& geode) override;

  const std::vector<LargeMesh>& getMeshes() const { return this->meshes; }
  const std::vector<ShownSurface>& getShown() const { return this->shown; }

private:
  std::size_t leastTriangles;
  bool viewMirrored;
  std::vector<LargeMesh> meshes;
  std::vector<ShownSurface> shown;
};

} // namespace shadow
