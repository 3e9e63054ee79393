#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "Judge.h"
#include "SceneWindow.h"

namespace shadow::fuzz
{

/// A scene's truth and all its masks.
struct DrawnScene
{
  std::unique_ptr<CertainPixels> truth;
  std::vector<DrawnMask> masks;
};

/// Draws and judges one scene after the other.
class FuzzSession
{
public:
  /// By Auto, by z-fail, and by the scene's configs, where z-pass is left out when a shadow may
  /// meet the near plane, see isNearPlaneLit().
  DrawnScene draw(const FuzzScene& scene);

  /// @param enough  see judgeMasks()
  SceneVerdict judge(const FuzzScene& scene, std::size_t enough = std::numeric_limits<std::size_t>::max());

private:
  SceneWindow window;
};

/// Every silhouette method by every stencil method, the first with both count buffers, and the two ways to
/// put the picture together.
std::vector<FuzzConfig> listEveryConfig();

} // namespace shadow::fuzz
