#include "EdgeQuadSilhouette.h"

#include <vtkShaderProgram.h>

#include <glm/gtc/type_ptr.hpp>

namespace shadow
{

bool EdgeQuadSilhouette::drawSides(const Surface& surface, const Light& light, StencilCount count, bool fan)
{
  vtkShaderProgram* program = this->useForVolume(ShadowPrograms::Sides, surface, light);
  if (program == nullptr)
  {
    return false;
  }
  const SEDGeometry& geometry = surface.geode->getGeometry();
  const glm::vec3 apex = chooseApex(geometry, surface.state->lights.at(light.index).lightMC);
  program->SetUniform3f("apexMC", glm::value_ptr(apex));
  setDepthBias(program, this->getFrame().reversedDepth, true);
  this->countWith(program, surface, count)
      .count(1, false, [&] { this->quads.draw(geometry.getEdges().size(), fan); });
  return true;
}

void EdgeQuadSilhouette::release(bool contextLost)
{
  this->quads.release(contextLost);
  this->GPUSilhouette::release(contextLost);
}

std::size_t EdgeQuadSilhouette::getMemorySize() const
{
  return this->quads.getMemorySize() + this->GPUSilhouette::getMemorySize();
}

} // namespace shadow
