#pragma once

#include <string>

namespace shadow
{

/// What the current GL context can do for the shadow stages.
struct Capabilities
{
  bool usable = false;        ///< everything that cannot be done without is there
  std::string missing;        ///< one line, when not usable
  bool clipControl = false;   ///< GL 4.5 or ARB_clip_control: reversed depth
  bool sampleShading = false; ///< GL 4.0 or ARB_sample_shading: a shader can look at one sample
  bool software = false;      ///< Mesa's software rasterisers
  int maximumSamples = 1;     ///< of integer, float and depth textures
};

/// Asks the current context. @pre a context is current and VTK has loaded its functions
Capabilities queryCapabilities();

} // namespace shadow
