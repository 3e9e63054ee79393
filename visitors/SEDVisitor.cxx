#include "SEDVisitor.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>

#include "CountableVolumes.h"
#include "Revision.h"

namespace shadow
{

namespace
{

void markSide(const SEDGeometry& geometry, PathState& path)
{
  path.reachableMarked = path.marked;
  if (path.marked.bit == 0)
  {
    return;
  }
  const FacingBits& inputReversed = geometry.getInputReversed();
  for (std::size_t triangle = 0; triangle < path.reachableBits.size(); ++triangle)
  {
    const bool rasterFront = path.marked.inputFront != inputReversed.test(triangle);
    glm::uvec2& bits = path.reachableBits[triangle];
    (rasterFront ? bits.x : bits.y) &= ~path.marked.bit;
  }
}

// Raster-front and raster-back word of every triangle. Lights that are not in the list reach everything.
void composeReachableBits(const SEDGeometry& geometry, const std::vector<Light>& lights, PathState& path)
{
  std::uint32_t shadowed = 0;
  for (const Light& light : lights)
  {
    shadowed |= path.lights[light.index].faced ? 1u << static_cast<unsigned>(light.index) : 0u;
  }
  path.reachableBits.assign(geometry.getTriangles().size(), glm::uvec2(~shadowed));
  markSide(geometry, path);
  const FacingBits& reversed = geometry.getReversed();
  for (const Light& light : lights)
  {
    const PathLightState& state = path.lights[light.index];
    if (!state.faced)
    {
      continue;
    }
    const auto& towards = state.facing.towards.getWords();
    const auto& away = state.facing.away.getWords();
    const auto& turned = reversed.getWords();
    for (std::size_t word = 0; word < towards.size(); ++word)
    {
      // A reversed triangle's raster-front is its oriented back.
      const std::uint64_t front = (towards[word] & ~turned[word]) | (away[word] & turned[word]);
      const std::uint64_t back = (away[word] & ~turned[word]) | (towards[word] & turned[word]);
      const std::size_t first = 64 * word;
      const std::size_t end = std::min<std::size_t>(first + 64, path.reachableBits.size());
      for (std::size_t triangle = first; triangle < end; ++triangle)
      {
        const auto shift = static_cast<unsigned>(triangle - first);
        path.reachableBits[triangle].x |= static_cast<std::uint32_t>((front >> shift) & 1u) << light.index;
        path.reachableBits[triangle].y |= static_cast<std::uint32_t>((back >> shift) & 1u) << light.index;
      }
    }
  }
  path.reachableRevision = nextRevision();
}

} // namespace

void SEDVisitor::apply(SEDGeode& geode)
{
  PathState& path = geode.getPathState(this->getPath());
  if (this->stage == Stage::Face)
  {
    this->face(geode, path);
    return;
  }
  for (const Light& light : this->lights)
  {
    PathLightState& state = path.lights[light.index];
    const bool wanted = state.faced && state.plan.count != StencilCount::Skip;
    const bool upToDate = state.extruded && state.finderId == this->finder.getId() &&
                          state.extrudedPlan.hasFacesOf(state.plan) &&
                          state.extrudedCountable == this->countable;
    if (wanted)
    {
      ++this->usedMethods[this->finder.getMethod(geode.getGeometry())];
    }
    if (wanted && !upToDate)
    {
      extrudeForPlan(geode.getGeometry(), this->finder, this->countable, state);
      ++this->rebuiltVolumes;
    }
  }
}

void SEDVisitor::face(SEDGeode& geode, PathState& path)
{
  const SEDGeometry& geometry = geode.getGeometry();
  bool facingChanged = path.reachableRevision == 0 || !(path.marked == path.reachableMarked);
  for (auto entry = path.lights.begin(); entry != path.lights.end();)
  {
    const bool known = std::any_of(this->lights.begin(), this->lights.end(),
                                   [&](const Light& light) { return light.index == entry->first; });
    facingChanged = facingChanged || !known;
    entry = known ? std::next(entry) : path.lights.erase(entry);
  }
  for (const Light& light : this->lights)
  {
    PathLightState& state = path.lights[light.index];
    const std::optional<glm::dvec4> lightMC =
        lightToModel(light, this->getModelToWorld(), geometry.getOrigin());
    if (!lightMC)
    {
      // The transform flattens the geode: there is no inside to cast from.
      facingChanged = facingChanged || state.faced;
      state = {};
      continue;
    }
    if (!path.inView && state.plan.count == StencilCount::Skip)
    {
      continue;
    }
    if (!state.faced || state.lightMC != *lightMC)
    {
      state.lightMC = *lightMC;
      state.needsExactVolumes.reset();
      this->finder.face(geometry, *lightMC, state.facing);
      state.faced = true;
      state.extruded = false;
      facingChanged = true;
    }
  }
  if (facingChanged && path.inView)
  {
    composeReachableBits(geometry, this->lights, path);
  }
  else if (facingChanged)
  {
    path.reachableRevision = 0;
  }
}

void extrudeForPlan(const SEDGeometry& geometry, const SilhouetteFinder& finder, std::size_t countable,
                    PathLightState& state)
{
  ShadowVolumeOptions options;
  options.lightCap = state.plan.lightCap;
  options.darkCap = state.plan.darkCap;
  options.farAtInfinity = state.plan.isFarAtInfinity();
  options.countable = countable;
  state.volumes = makeCountableVolumes(geometry, finder, state.facing, state.lightMC, options);
  state.extruded = true;
  state.extrudedPlan = state.plan;
  state.extrudedCountable = countable;
  state.finderId = finder.getId();
  state.revision = nextRevision();
}

} // namespace shadow
