#include "DrawVisitor.h"

#include <algorithm>
#include <cmath>

#include "OpenGL.h"

namespace shadow
{

void DrawVisitor::apply(SEDGeode& geode)
{
  PathState& path = geode.getPathState(this->getPath());
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
  glFrontFace(mirrored ? GL_CW : GL_CCW);
  SEDGeometryDrawable& drawable = this->pass.drawables->getGeometry(geode.getSharedGeometry());
  const ReachableBitsBuffer& reachableBits =
      this->pass.drawables->getReachableBits(path, drawable.getVertexCount());
  if (this->getFaceCulling() != FaceCulling::None)
  {
    // VTK calls back what is clockwise on the screen, mirrored or not.
    const bool front = (this->getFaceCulling() == FaceCulling::Front) != mirrored;
    drawable.drawCulled(this->pass.state, this->pass.program, reachableBits, front ? GL_FRONT : GL_BACK);
  }
  else
  {
    drawable.draw(this->pass.program, reachableBits);
  }
  glFrontFace(GL_CCW);
  this->counts.geometry += geode.getGeometry().getTriangles().size();
}

void DrawVisitor::drawVolumes(const SEDGeode& geode, const PathLightState& light, StencilCount count)
{
  const glm::dmat4 wcFromMC = worldFromRelative(geode.getGeometry(), this->getModelToWorld());
  const bool mirrored = this->setMatrices(wcFromMC);
  setUniform(this->pass.program, "lightMC", light.lightMC);
  // A plane goes the other way: as a row vector from the left.
  glm::dvec4 farPlaneMC = light.plan.farPlaneWC * wcFromMC;
  farPlaneMC /= std::max(glm::length(glm::dvec3(farPlaneMC)), std::abs(farPlaneMC.w));
  setUniform(this->pass.program, "farPlaneMC", farPlaneMC);
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
