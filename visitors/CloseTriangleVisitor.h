#pragma once

#include <cstddef>
#include <vector>

#include "Light.h"
#include "NodeVisitor.h"
#include "SEDGeode.h"
#include "SilhouetteFinder.h"

namespace shadow
{

/// Has every SEDGeode build its volumes on the CPU for the lights that are very close to one of its triangles:
/// for methods that keep silhouettes on the GPU, which cannot draw these (see CloseTriangles.h). Of all other
/// lights no volume is kept.
///
/// @pre  the CasterCuller and the GPUSilhouetteVisitor have been here before
/// @par Cost  O(1) for each path and light that is outside of the bounding box; O(triangles) once a light
class CloseTriangleVisitor : public NodeVisitor
{
public:
  /// @param theCountable  see ShadowVolumeOptions
  CloseTriangleVisitor(const std::vector<Light>& theLights, const SilhouetteFinder& theFinder,
                       std::size_t theCountable)
      : lights(theLights), finder(theFinder), countable(theCountable)
  {
  }

  using NodeVisitor::apply;
  void apply(SEDGeode& geode) override;

  /// Volumes are there to be drawn.
  bool hasVolumes() const { return this->found; }

private:
  void refresh(const SEDGeometry& geometry, PathLightState& state);

  const std::vector<Light>& lights;
  const SilhouetteFinder& finder;
  std::size_t countable;
  bool found = false;
};

} // namespace shadow
