#pragma once

#include <string>

namespace shadow
{

/// What the current GL context can do for the shadow stages.
struct Capabilities
{
  bool usable = false;      ///< everything that cannot be done without is there
  std::string missing;      ///< one line, when not usable
  bool clipControl = false; ///< GL 4.5 or ARB_clip_control: reversed depth
  int maximumSamples = 1;   ///< of integer and depth textures
};

/// Asks the current context. @pre a context is current and VTK has loaded its functions
Capabilities queryCapabilities();

} // namespace shadow
