#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "Light.h"
#include "NodeVisitor.h"
#include "SEDGeode.h"
#include "SilhouetteFinder.h"

namespace shadow
{

/// Has every SEDGeode build or refresh, for each light, the facing of its triangles and its shadow volume.
/// What belongs to an unchanged light, transform and plan is kept.
///
/// @pre  the CasterCuller has been here before
/// @par Source  Shi 2006, chapter 4.2.2
class SEDVisitor : public NodeVisitor
{
public:
  SEDVisitor(const std::vector<Light>& theLights, const SilhouetteFinder& theFinder)
    : lights(theLights)
    , finder(theFinder)
  {
  }

  using NodeVisitor::apply;
  void apply(SEDGeode& geode) override;

  int getRebuiltVolumes() const { return this->rebuiltVolumes; }

  /// Geodes whose transform flattens them: they have no inside to cast from.
  const std::set<std::string>& getFlattened() const { return this->flattened; }

private:
  void refreshVolume(const SEDGeometry& geometry, PathLightState& state);

  const std::vector<Light>& lights;
  const SilhouetteFinder& finder;
  int rebuiltVolumes = 0;
  std::set<std::string> flattened;
};

} // namespace shadow
