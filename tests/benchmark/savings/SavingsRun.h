#pragma once

#include <string>
#include <utility>
#include <vector>

#include "SavingsScene.h"

namespace shadow::benchmarks
{

/// A way to draw frames.
struct SavingsDrawer
{
  std::string name;
  int savings = 0; ///< vtkShadowVolumePass::SavingsFlags
};

/// All savings on, each off, all off, in this order.
const std::vector<SavingsDrawer>& savingsDrawers();

/// What one drawer took for one scene in which one thing moves.
struct SavingsSample
{
  double milliseconds = 0.0; ///< of a frame, median
  /// Work of the last frame that does not depend on the machine.
  std::vector<std::pair<std::string, long long>> work;
};

struct SavingsRow
{
  SavingsSceneSize scene;
  Moves moves = Moves::Nothing;
  double plain = 0.0; ///< milliseconds of a frame by VTK alone
  double map = 0.0;   ///< by vtkShadowMapPass, 2048 x 2048
  std::vector<SavingsSample> samples; ///< of savingsDrawers()

  const SavingsSample& all() const { return this->samples.front(); }
};

/// Draws a scene by plain VTK, the shadow map and every drawer in turns.
/// @throws std::runtime_error when the GL cannot draw shadow volumes
SavingsRow measureSavings(const SavingsSceneSize& size, Moves moves, int width, int height, int rounds);

} // namespace shadow::benchmarks
