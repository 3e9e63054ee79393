#include "ScreenRectangle.h"

#include <limits>

namespace shadow
{

ScreenRectangle joined(const ScreenRectangle& one, const ScreenRectangle& other)
{
  if (one.isEmpty() || other.isEmpty())
  {
    return one.isEmpty() ? other : one;
  }
  return {glm::min(one.lower, other.lower), glm::max(one.upper, other.upper)};
}

ScreenRectangle coverOf(const BoxCorners& cornersWC, const View& view)
{
  // Rasterisers round corners to a part of a pixel, and samples lie anywhere in theirs.
  constexpr double margin = 2.0;
  const glm::dvec2 size(view.width, view.height);
  glm::dvec2 lower(std::numeric_limits<double>::max());
  glm::dvec2 upper(std::numeric_limits<double>::lowest());
  for (const glm::dvec3& corner : cornersWC)
  {
    const glm::dvec4 clip = view.clipFromWC * glm::dvec4(corner, 1.0);
    const glm::dvec2 pixel = (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * size;
    // Not so for NaN either.
    const bool inFront = clip.w > 1e-9 * glm::length(glm::dvec3(clip)) && glm::length(pixel) < 1e12;
    if (!inFront)
    {
      return wholeView(view);
    }
    lower = glm::min(lower, pixel);
    upper = glm::max(upper, pixel);
  }
  lower = glm::clamp(glm::floor(lower - margin), glm::dvec2(0.0), size);
  upper = glm::clamp(glm::ceil(upper + margin), glm::dvec2(0.0), size);
  return {glm::ivec2(lower), glm::ivec2(upper)};
}

} // namespace shadow
