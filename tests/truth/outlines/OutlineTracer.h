#pragma once

#include <vector>

#include "OutlineTruth.h"

namespace shadow::truth
{

/// Follows edges across the view and tells which parts of them are visible. May be used by several threads.
class OutlineTracer
{
public:
  /// @param scene  the caster's
  /// @param reach  how far outside the view edges are still followed, in pixels
  OutlineTracer(const RayCaster& theCaster, const PixelRays& theRays, const View& view,
                const OutlineOffsets& theOffsets, double theReach)
      : caster(theCaster), rays(theRays), size(view.width, view.height), offsets(theOffsets), reach(theReach)
  {
  }

  /// Adds the parts of an edge that may be visible in and around the view.
  ///
  /// @par Cost  five rays for each quarter of a pixel
  void trace(const OutlineEdge& edge, std::vector<OutlinePiece>& pieces) const;

private:
  /// What is known of a point.
  enum class Sight : unsigned char
  {
    Hidden,
    Perhaps,
    Visible
  };

  /// An edge on the screen: from and to in pixels, and what its points have in clip space there.
  struct Track
  {
    glm::dvec4 clipFrom, clipTo; ///< see PixelRays::toClip()
    glm::dvec2 from, to;         ///< pixels
    bool wholeFrom = true;       ///< its end is the edge's
    bool wholeTo = true;
    double first = 0.0, last = 1.0; ///< of the way from from to to: the part in and around the view
  };

  bool follow(const OutlineEdge& edge, Track& track) const;
  Sight look(const OutlineEdge& edge, const Track& track, double at) const;
  bool seesEdgeOf(const OutlineEdge& edge, const glm::dvec2& pixel) const;
  bool isHidden(const OutlineEdge& edge, const glm::dvec2& pixel, double height) const;

  const RayCaster& caster;
  const PixelRays& rays;
  glm::ivec2 size;
  OutlineOffsets offsets;
  double reach;
};

} // namespace shadow::truth
