#pragma once

#include <vector>

#include "FacingTexture.h"
#include "GPUFacingBound.h"
#include "Light.h"
#include "NodeVisitor.h"
#include "SEDGeode.h"
#include "SceneFrame.h"

namespace shadow
{

/// Gives every SEDGeode the facing that a FacingTexture has read back, where no volume is kept; and where the
/// GPU is not sure of it, the exact one.
///
/// @pre  the GPUSilhouetteVisitor has been here before, to prepare
/// @par Source  Shi 2006, chapter 4.3
class ReadFacingVisitor : public NodeVisitor
{
public:
  /// @param theFrame  that of the texture's corners
  ReadFacingVisitor(const FacingTexture& theTexture, const SceneFrame& theFrame,
                    const std::vector<Light>& theLights)
      : texture(theTexture), frame(theFrame), lights(theLights)
  {
  }

  using NodeVisitor::apply;
  void apply(SEDGeode& geode) override
  {
    const SEDGeometry& geometry = geode.getGeometry();
    PathState& path = geode.getPathState(this->getPath());
    for (const Light& light : this->lights)
    {
      PathLightState& state = path.lights[light.index];
      if (state.faced && !state.extruded)
      {
        const GPUFacingBound bound = GPUFacingBound::inScene(geometry, this->getModelToWorld(), this->frame,
                                                             light, state.lightMC);
        if (computeFacing(geometry, state.lightMC, bound, state.facing))
        {
          this->texture.getFacing(this->getPath(), light, state.facing);
        }
      }
    }
  }

private:
  const FacingTexture& texture;
  const SceneFrame& frame;
  const std::vector<Light>& lights;
};

} // namespace shadow
