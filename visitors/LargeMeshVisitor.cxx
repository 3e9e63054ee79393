#include "LargeMeshVisitor.h"

namespace shadow
{

bool ShownSurface::operator==(const ShownSurface& other) const
{
  // Not by address: another geometry may have taken the place of one that is gone.
  return this->path == other.path && !this->geometry.owner_before(other.geometry) &&
         !other.geometry.owner_before(this->geometry) && this->modelToWorld == other.modelToWorld &&
         this->culling == other.culling;
}

void LargeMeshVisitor::apply(SEDGeode& geode)
{
  PathState& state = geode.getPathState(this->getPath());
  state.marked = {};
  state.hiddenSide = FaceCulling::None;
  if (!state.inView)
  {
    return;
  }
  this->shown.push_back(
      {this->getPath(), geode.getSharedGeometry(), this->getModelToWorld(), this->getFaceCulling()});
  const SEDGeometry& geometry = geode.getGeometry();
  const std::size_t triangles = geometry.getTriangles().size();
  if (triangles >= this->leastTriangles && this->getFaceCulling() == FaceCulling::None)
  {
    const bool inwards = 2 * geometry.getReport().flippedTriangles > triangles;
    // VTK calls back what is clockwise on the screen, mirrored or not.
    const bool mirrored = this->viewMirrored != (glm::determinant(glm::dmat3(this->getModelToWorld())) < 0.0);
    this->meshes.push_back({this->getPath(), &state, triangles, inwards,
                            inwards != mirrored ? FaceCulling::Front : FaceCulling::Back});
  }
}

} // namespace shadow
