#pragma once

#include <string>

#include "ShadowVolumeEffect.h"

class vtkOpenGLRenderWindow;

namespace shadow
{

/// Whether what the GL draws for a silhouette method is right.
struct MethodCheck
{
  std::string fault;         ///< one line; empty when it is right
  bool drawn = true;         ///< false where the GL refuses to draw, which is no fault
  double milliseconds = 0.0; ///< 0 where it was known
};

/// Has an effect draw KnownScene, by z-fail and by what Auto chooses, unless that was done before in the
/// window's GL context for the same way through the GL: method (one for all on the CPU), count buffer, samples,
/// parallel or perspective view, meshes drawn together or not.
///
/// What is not drawn at all, since the GL refuses it, is no fault: who draws the picture will be told.
///
/// @param effect  for settings.silhouetteMethod; what it compiles here is what it draws with
/// @pre   the window's context is current
/// @post  GL state is as it was. @p effect has no children, unless what it draws was known
/// @par Cost  once some milliseconds, beside those for shaders that are compiled here first; then a look-up
MethodCheck checkMethod(vtkOpenGLRenderWindow* window, ShadowVolumeEffect& effect,
                        const ShadowVolumeEffect::Settings& settings, bool parallelView);

} // namespace shadow
