#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "CasterCuller.h"
#include "FaceCounter.h"
#include "KeptBits.h"
#include "Light.h"
#include "SilhouetteFinder.h"
#include "SurfaceCollector.h"

namespace shadow
{

/// All that a shadow mask is made from, as values: whatever has changed in a scene shows here, or the mask does
/// not depend on it.
struct MaskInputs
{
  /// What the stages do.
  struct Way
  {
    StencilMethod stencilMethod = StencilMethod::Auto;
    SilhouetteMethod silhouetteMethod = SilhouetteMethod::Auto;
    CountBuffer countBuffer = CountBuffer::Stencil; ///< that is used
    double coplanarTolerance = 0.0;
    int samples = 1;
    int viewSamples = 0; ///< a pixel of the framebuffer that VTK draws into
    bool findHiddenBacks = false;

    bool operator==(const Way& other) const;
  };

  Way way;
  glm::dmat4 clipFromWC{1.0}; ///< all else in a View comes from this and the size
  int width = 0;
  int height = 0;
  std::vector<CollectedSurface> surfaces;
  std::vector<Light> lights;

  /// Whether a mask made from the others, but for lights, has the same surfaces in its pixels.
  bool hasViewOf(const MaskInputs& other) const;

  /// The lights whose bits are those of a mask made from the others: the same light casts the same shadow,
  /// whatever its place among lights. @pre hasViewOf(before)
  KeptBits findKept(const MaskInputs& before) const;
};

} // namespace shadow
