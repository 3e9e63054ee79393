#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "Light.h"
#include "NodeVisitor.h"
#include "SEDGeode.h"
#include "SilhouetteFinder.h"

namespace shadow
{

/// Has every SEDGeode build or refresh, for each light, the facing of its triangles or its shadow volume.
/// What belongs to an unchanged light, transform, plan and finder is kept.
///
/// Two walks, so that the GL can work on the pre-pass, which needs the facing, while the CPU finds
/// silhouettes.
///
/// @pre  the CasterCuller has been here before
/// @par Source  Shi 2006, chapter 4.2.2
class SEDVisitor : public NodeVisitor
{
public:
  enum class Stage
  {
    Face,   ///< which lights every triangle faces
    Extrude ///< silhouettes and volumes; after Face
  };

  /// @param theCountable  see ShadowVolumeOptions; for Extrude
  SEDVisitor(Stage theStage, const std::vector<Light>& theLights, const SilhouetteFinder& theFinder,
             std::size_t theCountable = mostCountable)
      : stage(theStage), lights(theLights), finder(theFinder), countable(theCountable)
  {
  }

  using NodeVisitor::apply;
  void apply(SEDGeode& geode) override;

  int getRebuiltVolumes() const { return this->rebuiltVolumes; }

  /// How many of the volumes to be drawn, kept ones included, each method has found.
  const std::map<SilhouetteMethod, int>& getUsedMethods() const { return this->usedMethods; }

private:
  void face(SEDGeode& geode, PathState& path);

  Stage stage;
  const std::vector<Light>& lights;
  const SilhouetteFinder& finder;
  std::size_t countable;
  int rebuiltVolumes = 0;
  std::map<SilhouetteMethod, int> usedMethods;
};

/// The volumes of one path and light, for the plan that the CasterCuller has left.
/// @pre  state.facing is that of state.lightMC
/// @param countable  see ShadowVolumeOptions
void extrudeForPlan(const SEDGeometry& geometry, const SilhouetteFinder& finder, std::size_t countable,
                    PathLightState& state);

} // namespace shadow
