#include "CloseTriangleVisitor.h"

#include "CloseTriangles.h"
#include "SEDVisitor.h"

namespace shadow
{

void CloseTriangleVisitor::apply(SEDGeode& geode)
{
  PathState& path = geode.getPathState(this->getPath());
  for (const Light& light : this->lights)
  {
    PathLightState& state = path.lights[light.index];
    if (state.faced && state.plan.count != StencilCount::Skip)
    {
      this->refresh(geode.getGeometry(), state);
    }
    else
    {
      state.extruded = false;
    }
    this->found = this->found || state.extruded;
  }
}

void CloseTriangleVisitor::refresh(const SEDGeometry& geometry, PathLightState& state)
{
  const bool ours = state.hasCloseTriangles == true && state.finderId == this->finder.getId();
  if (ours && state.extruded && state.extrudedPlan.hasFacesOf(state.plan))
  {
    return;
  }
  state.extruded = false;
  if (state.hasCloseTriangles == false || !mayHaveCloseTriangles(geometry, state.lightMC))
  {
    return;
  }
  this->finder.face(geometry, state.lightMC, state.facing);
  const Casting casts = chooseCasting(geometry, state.lightMC);
  state.hasCloseTriangles = !findCloseTriangles(geometry, state.facing, casts, state.lightMC).empty();
  if (*state.hasCloseTriangles)
  {
    extrudeForPlan(geometry, this->finder, this->countable, state);
  }
}

} // namespace shadow
