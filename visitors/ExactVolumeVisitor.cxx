#include "ExactVolumeVisitor.h"

#include <utility>

#include "CloseTriangles.h"
#include "SEDVisitor.h"

namespace shadow
{

void ExactVolumeVisitor::apply(SEDGeode& geode)
{
  PathState& path = geode.getPathState(this->getPath());
  for (const Light& light : this->lights)
  {
    PathLightState& state = path.lights[light.index];
    if (state.faced && state.plan.count != StencilCount::Skip)
    {
      this->refresh(geode.getGeometry(), light, state);
    }
    else
    {
      state.extruded = false;
    }
    this->found = this->found || state.extruded;
  }
}

void ExactVolumeVisitor::refresh(const SEDGeometry& geometry, const Light& light, PathLightState& state)
{
  const bool ours = state.needsExactVolumes == true && state.finderId == this->finder.getId();
  if (ours && state.extruded && state.extrudedPlan.hasFacesOf(state.plan))
  {
    return;
  }
  state.extruded = false;
  const GPUFacingBound bound = this->frame != nullptr
                                   ? GPUFacingBound::inScene(geometry, this->getModelToWorld(), *this->frame,
                                                             light, state.lightMC)
                                   : GPUFacingBound::inModel(geometry, state.lightMC);
  if (state.needsExactVolumes == false && state.facingBound == bound)
  {
    return;
  }
  state.facingBound = bound;
  state.needsExactVolumes = this->needsExact(geometry, state);
  if (*state.needsExactVolumes)
  {
    std::swap(state.facing, this->facing);
    extrudeForPlan(geometry, this->finder, this->countable, state);
  }
}

bool ExactVolumeVisitor::needsExact(const SEDGeometry& geometry, const PathLightState& state)
{
  if (!computeFacing(geometry, state.lightMC, state.facingBound, this->facing))
  {
    return true;
  }
  return mayHaveCloseTriangles(geometry, state.lightMC) &&
         !findCloseTriangles(geometry, this->facing, chooseCasting(geometry, state.lightMC), state.lightMC)
              .empty();
}

} // namespace shadow
