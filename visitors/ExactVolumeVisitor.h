#pragma once

#include <cstddef>
#include <vector>

#include "GPUFacingBound.h"
#include "Light.h"
#include "NodeVisitor.h"
#include "SEDGeode.h"
#include "SceneFrame.h"
#include "SilhouetteFinder.h"

namespace shadow
{

/// Has every SEDGeode build its volumes on the CPU where methods that keep silhouettes on the GPU cannot draw
/// them right: for lights very close to one of its triangles (see CloseTriangles.h), and for those of which
/// the GPU may get wrong which side of a triangle they are on (see GPUFacingBound). Of all other lights no
/// volume is kept.
///
/// @pre  the CasterCuller and the GPUSilhouetteVisitor have been here before
/// @par Cost  of a cluster tree's facing for each path and light that has moved; O(triangles) where the light
///            is in the bounding box
class ExactVolumeVisitor : public NodeVisitor
{
public:
  /// @param theFrame      where the GPU decides facing; nullptr: in each geometry's own space
  /// @param theCountable  see ShadowVolumeOptions
  ExactVolumeVisitor(const std::vector<Light>& theLights, const SceneFrame* theFrame,
                     const SilhouetteFinder& theFinder, std::size_t theCountable)
      : lights(theLights), frame(theFrame), finder(theFinder), countable(theCountable)
  {
  }

  using NodeVisitor::apply;
  void apply(SEDGeode& geode) override;

  /// Volumes are there to be drawn.
  bool hasVolumes() const { return this->found; }

private:
  void refresh(const SEDGeometry& geometry, const Light& light, PathLightState& state);
  bool needsExact(const SEDGeometry& geometry, const PathLightState& state);

  const std::vector<Light>& lights;
  const SceneFrame* frame;
  const SilhouetteFinder& finder;
  std::size_t countable;
  LightFacing facing; ///< of the last path and light that it was asked of
  bool found = false;
};

} // namespace shadow
