#pragma once

#include <vector>

namespace shadow::robustness
{

class HardScene;

/// A scene that is easy to get wrong. Every silhouette method is run on it, with every stencil method.
struct HardCase
{
  const char* name;
  void (*build)(HardScene& scene);

  /// Z-pass counts between the eye and the surface only, so it is wrong where the near plane is in a shadow
  /// volume.
  bool zPassIsRight = true;

  /// Whether some pixels have to be lit and some in shadow, so that an empty mask cannot pass.
  bool isMixed = true;

  /// Part of the status message when the pass has to refuse something; null when it must not.
  const char* refusal = nullptr;
};

std::vector<HardCase> lightAtMeshCases();
std::vector<HardCase> lightInViewCases();
std::vector<HardCase> cameraCases();
std::vector<HardCase> viewCases();
std::vector<HardCase> meshCases();
std::vector<HardCase> coincidentCases();
std::vector<HardCase> numberCases();
std::vector<HardCase> overlapCases();
std::vector<HardCase> badInputCases();

} // namespace shadow::robustness
