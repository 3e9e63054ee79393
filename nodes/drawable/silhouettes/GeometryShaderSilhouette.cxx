#include "GeometryShaderSilhouette.h"

#include <vtkShaderProgram.h>

#include <glm/gtc/type_ptr.hpp>

namespace shadow
{

// Through a geometry shader only where depth is rounded differently after one: it takes time, and one of
// NVIDIA's compilers (580.159) gives surface.geom zero for what the third corner hands on.
ShadowPrograms::Stage GeometryShaderSilhouette::getVolumeStage() const
{
  return this->getFrame().software ? ShadowPrograms::VolumeInColorHandedOn : ShadowPrograms::VolumeInColor;
}

ShadowPrograms::Stage GeometryShaderSilhouette::getSurfaceStage() const
{
  return this->getFrame().software ? ShadowPrograms::SurfacePrePassHandedOn : ShadowPrograms::SurfacePrePass;
}

bool GeometryShaderSilhouette::drawVolume(const Surface& surface, const Light& light, StencilCount count)
{
  const PathLightState& state = surface.state->lights.at(light.index);
  const DarkCap darkCap = chooseDarkCap(light, state.plan);
  const bool caps = state.plan.lightCap || darkCap != DarkCap::None;
  vtkShaderProgram* program = this->useForVolume(ShadowPrograms::VolumeOfTriangles, surface, light,
                                                 caps ? "#define SHADOW_CAPS\n" : "");
  if (program == nullptr)
  {
    return false;
  }
  setDepthBias(program, this->getFrame().reversedDepth, true, "sideBias");
  if (caps)
  {
    program->SetUniformi("lightCap", state.plan.lightCap ? 1 : 0);
    program->SetUniformi("darkTriangles", darkCap == DarkCap::Triangles ? 1 : 0);
    program->SetUniformi("darkFan", darkCap == DarkCap::Fan ? 1 : 0);
    const glm::vec3 apex = chooseApex(surface.geode->getGeometry(), state.lightMC);
    program->SetUniform3f("apexMC", glm::value_ptr(apex));
  }
  const AdjacentTriangles& triangles =
      this->getFrame().drawables->getGeometry(surface.geode->getSharedGeometry()).getAdjacentTriangles();
  this->countWith(program, surface, count).count(1, false, [&] { triangles.draw(); });
  return true;
}

} // namespace shadow
