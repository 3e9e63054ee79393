#pragma once

#include <glm/glm.hpp>

#include "SEDGeode.h"
#include "View.h"

namespace shadow
{

/// A rectangle of a view's pixels.
struct ScreenRectangle
{
  glm::ivec2 lower{0}; ///< the first one
  glm::ivec2 upper{0}; ///< after the last one

  bool isEmpty() const { return this->upper.x <= this->lower.x || this->upper.y <= this->lower.y; }
  bool operator==(const ScreenRectangle& other) const
  {
    return this->lower == other.lower && this->upper == other.upper;
  }
};

inline ScreenRectangle wholeView(const View& view)
{
  return {glm::ivec2(0), glm::ivec2(view.width, view.height)};
}

/// The smallest rectangle around both.
ScreenRectangle joined(const ScreenRectangle& one, const ScreenRectangle& other);

/// Pixels that what lies in a box may touch, and a few around them; the whole view where the box reaches behind the
/// eye.
ScreenRectangle coverOf(const BoxCorners& cornersWC, const View& view);

} // namespace shadow
