#pragma once

#include <string>

#include "SilhouetteFinder.h"

namespace shadow
{

/// What the current GL context can do for the shadow stages.
struct Capabilities
{
  bool usable = false;        ///< everything that cannot be done without is there
  std::string missing;        ///< one line, when not usable
  std::string version;        ///< of OpenGL: "4.5"
  bool clipControl = false;   ///< GL 4.5 or ARB_clip_control: reversed depth
  bool sampleShading = false; ///< GL 4.0 or ARB_sample_shading: a shader can look at one sample
  bool sampleCoverage = false; ///< GL 4.0 or ARB_gpu_shader5: a shader knows which samples a fragment covers
  bool compute = false;       ///< GL 4.3: compute shaders, and what they write to
  bool software = false;      ///< Mesa's software rasterisers
  int maximumSamples = 1;     ///< of integer, float and depth textures
};

/// Asks the current context. @pre a context is current and VTK has loaded its functions
Capabilities queryCapabilities();

/// What the GL lacks for a silhouette method, in a few words; empty when it lacks nothing.
///
/// @param samples  a pixel of the mask. The methods that keep silhouettes on the GPU count in colour, which
///                 takes sample shading for more than one
std::string findMissing(const Capabilities& capabilities, SilhouetteMethod method, int samples);

/// The method to use in place of one that cannot be used: the facing texture, kept on the GPU, read back, and
/// at last the CPU, which every GL can.
SilhouetteMethod nextBest(SilhouetteMethod method);

} // namespace shadow
