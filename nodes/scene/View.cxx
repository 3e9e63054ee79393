#include "View.h"

#include <cmath>

#include <glm/gtc/matrix_access.hpp>

namespace shadow
{

View makeView(const glm::dmat4& clipFromWC, int width, int height)
{
  View view;
  view.clipFromWC = clipFromWC;
  view.width = width;
  view.height = height;

  const glm::dvec4 x = glm::row(clipFromWC, 0);
  const glm::dvec4 y = glm::row(clipFromWC, 1);
  const glm::dvec4 z = glm::row(clipFromWC, 2);
  const glm::dvec4 w = glm::row(clipFromWC, 3);
  view.planes = {w + x, w - x, w + y, w - y, w + z};

  // A right-handed world becomes left-handed in clip space: the determinant is negative unless something
  // mirrors.
  view.mirrored = glm::determinant(clipFromWC) > 0.0;
  view.parallel = glm::length(glm::dvec3(w)) <= 1e-12 * glm::length(glm::dvec3(x));

  const glm::dmat4 wcFromClip = glm::inverse(clipFromWC);
  const std::array<glm::dvec2, 4> corners = {glm::dvec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}};
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const glm::dvec4 corner = wcFromClip * glm::dvec4(corners[i], -1.0, 1.0);
    view.nearWC[i] = glm::dvec3(corner) / corner.w;
  }
  const glm::dvec4 nearCentre(0.5 * (view.nearWC[0] + view.nearWC[2]), 1.0);
  view.nearW = glm::dot(w, nearCentre);

  // Distance from the near plane: its own plane, normalised, pointing into the view.
  const glm::dvec4 nearPlane = view.planes[4];
  view.viewDepth = nearPlane / glm::length(glm::dvec3(nearPlane));
  return view;
}

glm::dmat4 shadowClipFromWC(const View& view, const DepthRange& range)
{
  glm::dmat4 clip = view.clipFromWC;
  const glm::dvec4 w = glm::row(clip, 3);
  glm::dvec4 depth;
  if (view.parallel)
  {
    // 1 at nearest, 0 at farthest, times the constant w.
    const glm::dvec4 one(0.0, 0.0, 0.0, 1.0);
    depth = w.w * (range.farthest * one - view.viewDepth) / (range.farthest - range.nearest);
    depth = range.reversed ? depth : w.w * one - 2.0 * depth;
  }
  else
  {
    // nearW / w: 1 on the near plane, 0 at infinity. The first term is a constant, so far copies get exactly
    // 0.
    const glm::dvec4 nearTerm(0.0, 0.0, 0.0, view.nearW);
    depth = range.reversed ? nearTerm : w - 2.0 * nearTerm;
  }
  return glm::row(clip, 2, depth);
}

glm::dvec2 windowFromDepth(const View& view, const DepthRange& range)
{
  DepthRange reversed = range;
  reversed.reversed = true;
  // z of VTK's clip space = a w + b depth.
  const glm::dvec4 z = glm::row(view.clipFromWC, 2);
  const glm::dvec4 w = glm::row(view.clipFromWC, 3);
  const glm::dvec4 depth = glm::row(shadowClipFromWC(view, reversed), 2);
  const glm::dvec3 direction(view.parallel ? depth : w);
  const double ratio = glm::dot(glm::dvec3(z), direction) / glm::dot(direction, direction);
  const double a = view.parallel ? (z.w - ratio * depth.w) / w.w : ratio;
  const double b = view.parallel ? ratio : (z.w - ratio * w.w) / depth.w;
  return range.reversed ? glm::dvec2(0.5 + 0.5 * a, 0.5 * b) : glm::dvec2(0.5 + 0.5 * (a + b), -0.5 * b);
}

} // namespace shadow
