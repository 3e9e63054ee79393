#include "EdgeQuadSilhouette.h"

#include <vtkShaderProgram.h>

#include <glm/gtc/type_ptr.hpp>

namespace shadow
{

bool EdgeQuadSilhouette::drawSides(const Surface& surface, const Light& light, StencilCount count, bool fan)
{
  vtkShaderProgram* program =
      this->useForVolume(ShadowPrograms::Sides, surface, light, this->getSideSwitches());
  if (program == nullptr)
  {
    return false;
  }
  this->bindSilhouette(program, surface, light);
  const glm::vec3 apex =
      chooseApex(surface.geode->getGeometry(), surface.state->lights.at(light.index).lightMC);
  program->SetUniform3f("apexMC", glm::value_ptr(apex));
  setDepthBias(program, this->getFrame().reversedDepth, true);
  this->countWith(program, surface, count)
      .count(1, false, [&] { this->drawQuads(this->quads, surface, light, fan); });
  return true;
}

void EdgeQuadSilhouette::drawQuads(EdgeQuads& edgeQuads, const Surface& surface, const Light& /*light*/,
                                   bool fan)
{
  edgeQuads.draw(surface.geode->getGeometry().getEdges().size(), fan);
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
