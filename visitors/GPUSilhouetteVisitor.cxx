#include "GPUSilhouetteVisitor.h"

#include <algorithm>
#include <iterator>
#include <optional>

namespace shadow
{

void GPUSilhouetteVisitor::apply(SEDGeode& geode)
{
  PathState& path = geode.getPathState(this->getPath());
  if (this->stage == Stage::Prepare)
  {
    this->prepare(geode, path);
  }
  else if (this->error.empty())
  {
    this->draw(geode, path);
  }
}

void GPUSilhouetteVisitor::prepare(SEDGeode& geode, PathState& path)
{
  for (auto entry = path.lights.begin(); entry != path.lights.end();)
  {
    const bool known = std::any_of(this->lights.begin(), this->lights.end(),
                                   [&](const Light& light) { return light.index == entry->first; });
    entry = known ? std::next(entry) : path.lights.erase(entry);
  }
  for (const Light& light : this->lights)
  {
    PathLightState& state = path.lights[light.index];
    const std::optional<glm::dvec4> lightMC =
        lightToModel(light, this->getModelToWorld(), geode.getGeometry().getOrigin());
    if (!lightMC)
    {
      // The transform flattens the geode: there is no inside to cast from.
      state = {};
      continue;
    }
    if (state.lightMC != *lightMC)
    {
      state.extruded = false;
      state.needsExactVolumes.reset();
    }
    state.lightMC = *lightMC;
    this->facedAnew = this->facedAnew || !state.faced;
    state.faced = true;
  }
  if (this->error.empty())
  {
    this->method.prepare(this->describe(geode, path), this->error);
  }
}

GPUSilhouette::Surface GPUSilhouetteVisitor::describe(const SEDGeode& geode, const PathState& path) const
{
  return {&geode, &path, &this->getPath(), this->getModelToWorld(), this->getFaceCulling()};
}

void GPUSilhouetteVisitor::draw(const SEDGeode& geode, const PathState& path)
{
  static const char* const noShader = "a shader of the silhouette method does not compile on this GL";
  const SEDGeometry& geometry = geode.getGeometry();
  if (geode.renderMode.what == RenderMode::What::Geometry)
  {
    if (path.inView)
    {
      this->error = this->method.drawSurface(this->describe(geode, path)) ? "" : noShader;
      this->counts.geometry += geometry.getTriangles().size();
    }
    return;
  }
  const auto state = path.lights.find(geode.renderMode.light);
  if (state == path.lights.end() || !state->second.faced ||
      state->second.plan.count != geode.renderMode.count)
  {
    return;
  }
  if (state->second.extruded)
  {
    return; // the ExactVolumeVisitor has made volumes
  }
  const CasterPlan& plan = state->second.plan;
  const auto light =
      std::find_if(this->lights.begin(), this->lights.end(),
                   [&](const Light& candidate) { return candidate.index == geode.renderMode.light; });
  this->error = this->method.drawVolume(this->describe(geode, path), *light, plan.count) ? "" : noShader;
  this->drawn = true;
  this->counts.sides += 2 * geometry.getEdges().size();
  this->counts.caps += (plan.lightCap ? geometry.getTriangles().size() : 0) +
                       (plan.darkCap == DarkCap::Triangles ? geometry.getTriangles().size() : 0) +
                       (plan.darkCap == DarkCap::Fan ? geometry.getEdges().size() : 0);
}

} // namespace shadow
