#ifndef shadow_examples_RenderOptions_h
#define shadow_examples_RenderOptions_h

#include "OptionValues.h"

#include <optional>
#include <string>
#include <vector>

namespace shadow::examples
{

/// The command line of shadow_render, and what that of other programs has in common with it.
struct RenderOptions
{
  // what is shown
  std::vector<std::string> models; ///< none: the built-in scene
  bool floor = true;
  std::vector<LightOption> lights;     ///< none: one is chosen
  std::optional<CameraOption> camera;  ///< none: one is chosen
  std::optional<double> parallelScale; ///< half the height of the view in world units; none: perspective

  // how it is drawn; the numbers are vtkShadowVolumePass's
  int stencilMethod = 0;
  int silhouetteMethod = 0;
  int compositing = 0;
  int samples = 1;

  // what is written
  SizeOption size;
  std::string output = "shadow.png";
  std::string mask;          ///< empty: no mask
  std::string report;        ///< empty: no report
  std::optional<int> frames; ///< none: one picture, without a number in its name

  std::string help; ///< not empty: print this and stop
};

/// As many lights as the pass can tell apart.
constexpr std::size_t MAXIMUM_LIGHTS = 32;

/// Names on the command line, in the order of vtkShadowVolumePass's values.
const std::vector<std::string>& stencilNames();
const std::vector<std::string>& silhouetteNames();
const std::vector<std::string>& compositingNames();

/// What each silhouette method does, one line a method.
std::string describeSilhouettes();

/// Reads the command line of shadow_render; argv[0] is the program.
///
/// @throws UsageError  one line, for anything that is unknown, incomplete or out of range
RenderOptions parseRenderOptions(int argc, const char* const* argv);

} // namespace shadow::examples

#endif
