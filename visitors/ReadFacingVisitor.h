#pragma once

#include <vector>

#include "FacingTexture.h"
#include "Light.h"
#include "NodeVisitor.h"
#include "SEDGeode.h"

namespace shadow
{

/// Gives every SEDGeode the facing that a FacingTexture has read back, where no volume is kept.
///
/// @pre  the GPUSilhouetteVisitor has been here before, to prepare
/// @par Source  Shi 2006, chapter 4.3
class ReadFacingVisitor : public NodeVisitor
{
public:
  ReadFacingVisitor(const FacingTexture& theTexture, const std::vector<Light>& theLights)
      : texture(theTexture), lights(theLights)
  {
  }

  using NodeVisitor::apply;
  void apply(SEDGeode& geode) override
  {
    PathState& path = geode.getPathState(this->getPath());
    for (const Light& light : this->lights)
    {
      PathLightState& state = path.lights[light.index];
      if (state.faced && !state.extruded)
      {
        this->texture.getFacing(this->getPath(), light, state.facing);
      }
    }
  }

private:
  const FacingTexture& texture;
  const std::vector<Light>& lights;
};

} // namespace shadow
