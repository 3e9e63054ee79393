#include "DrawVisitor.h"

namespace shadow
{

void DrawVisitor::apply(SEDGeode& geode)
{
  PathState& path = geode.getPathState(this->getPath());
  if (path.batched)
  {
    return;
  }
  if (geode.renderMode.what == RenderMode::What::Geometry)
  {
    if (path.inView && path.reachableRevision != 0)
    {
      this->drawGeometry(geode, path);
    }
    return;
  }
  const auto light = path.lights.find(geode.renderMode.light);
  if (light != path.lights.end() && light->second.plan.count == geode.renderMode.count &&
      light->second.extruded)
  {
    this->drawVolumes(geode, light->second, geode.renderMode.count);
  }
}

// Sets the matrices; true when counter-clockwise in model space is clockwise on the screen.
bool DrawVisitor::setMatrices(const glm::dmat4& wcFromMC)
{
  setUniform(this->pass.program, "clipFromMC", this->pass.clipFromWC * wcFromMC);
  if (this->pass.view->parallel)
  {
    setUniform(this->pass.program, "nearFromMC", this->pass.view->viewDepth * wcFromMC);
  }
  return this->pass.view->mirrored != (glm::determinant(glm::dmat3(wcFromMC)) < 0.0);
}

void DrawVisitor::drawGeometry(const SEDGeode& geode, const PathState& path)
{
  const bool mirrored = this->setMatrices(worldFromRelative(geode.getGeometry(), this->getModelToWorld()));
  SEDGeometryDrawable& drawable = this->pass.drawables->getGeometry(geode.getSharedGeometry());
  const ReachableBitsBuffer& reachableBits =
      this->pass.drawables->getReachableBits(path, drawable.getVertexCount());
  const FaceCulling hidden = path.hiddenSide == FaceCulling::None ? this->getFaceCulling() : path.hiddenSide;
  drawable.drawPrePass(this->pass.state, this->pass.program, &reachableBits, hidden, mirrored);
  this->counts.geometry += geode.getGeometry().getTriangles().size();
}

void DrawVisitor::drawVolumes(const SEDGeode& geode, const PathLightState& light, StencilCount count)
{
  const glm::dmat4 wcFromMC = worldFromRelative(geode.getGeometry(), this->getModelToWorld());
  const bool mirrored = this->setMatrices(wcFromMC);
  setLight(this->pass.program, light.lightMC, geode.getGeometry().getReach());
  setUniform(this->pass.program, "farPlaneMC", farPlaneToModel(light.plan.farPlaneWC, wcFromMC));
  SEDGeometryDrawable& geometry = this->pass.drawables->getGeometry(geode.getSharedGeometry());
  for (std::size_t part = 0; part < light.volumes.size(); ++part)
  {
    const ShadowVolume& volume = light.volumes[part];
    if (volume.getTriangleCount() == 0)
    {
      continue;
    }
    this->pass.makeRoom(volume.overlapBound);
    const FaceCounter counter(
        {this->pass.state, this->pass.program, this->pass.countBuffer, this->pass.reversedDepth}, count,
        mirrored);
    ShadowVolumeDrawable& drawable = this->pass.drawables->getVolume(light, part);
    drawable.draw(counter, geometry.getVolumeVertexBuffer());
    this->counts.sides += volume.getSideCount();
    this->counts.caps += volume.getCapCount();
    this->counts.silhouetteEdges += volume.silhouetteEdges;
  }
}

} // namespace shadow
