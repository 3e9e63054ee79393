#pragma once

#include <cstddef>
#include <functional>

#include "FuzzScene.h"

namespace shadow::fuzz
{

/// Whether a scene, smaller than the one that was found, still shows what is wrong.
using StillWrong = std::function<bool(const FuzzScene&)>;

/// Bounds of the search.
struct ShrinkLimits
{
  std::size_t trials = 400; ///< scenes drawn
  double seconds = 30.0;
};

/// Makes a wrong scene small: leaves out ways to draw it, whole actors, halves, quarters and at last single
/// triangles, for as long as it stays wrong; then matrices, the cone and double precision.
///
/// @pre   stillWrong(scene)
/// @post  stillWrong(result); and unless a limit was met, no longer without any one of its triangles
/// @par Source  Zeller & Hildebrandt 2002, "Simplifying and Isolating Failure-Inducing Input"
FuzzScene shrink(const FuzzScene& scene, const StillWrong& stillWrong, const ShrinkLimits& limits = {});

} // namespace shadow::fuzz
