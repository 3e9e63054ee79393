#ifndef shadow_examples_OutlineOptions_h
#define shadow_examples_OutlineOptions_h

#include "RenderOptions.h"

#include <optional>

namespace shadow::examples
{

/// The command line of outline_render.
struct OutlineOptions : RenderOptions
{
  double width = 2.0;                  ///< pixels
  Vector3 colour = {0.0, 0.0, 0.0};    ///< red, green and blue, each from 0 to 1
  std::optional<double> creaseDegrees; ///< none: no creases
  bool hidden = false;                 ///< hidden lines are drawn faintly
  bool withShadows = false;
};

/// Reads the command line of outline_render; argv[0] is the program.
///
/// @throws UsageError  one line, for anything that is unknown, incomplete, out of range or without effect
OutlineOptions parseOutlineOptions(int argc, const char* const* argv);

} // namespace shadow::examples

#endif
