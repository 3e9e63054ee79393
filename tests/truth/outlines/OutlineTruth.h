#pragma once

#include <optional>
#include <vector>

#include "OutlineEdges.h"
#include "RayCaster.h"

namespace shadow::truth
{

/// How far beside a point of an edge its sight has to be the same to be certain, in pixels.
struct OutlineOffsets
{
  /// A visible point is certain when points so far outside the surface that ends in the edge, and as far from
  /// the eye as the edge, are visible, too. As far as rasterisers may move a vertex.
  double visible = 1.0 / 64.0;

  /// A hidden point is certain when so far outside that surface a point is hidden, too, and so far on either
  /// side none of the edge's own triangles is seen.
  double hidden = 1.0 / 64.0;
};

/// What an outline shows, and how well its truth is known.
struct OutlineOptions
{
  std::optional<double> creaseDegrees = std::nullopt; ///< none: silhouette and borders only

  OutlineOffsets offsets;

  /// Widest line that will be asked for, in pixels.
  double widest = 8.0;
};

/// A straight part of an edge on the screen, in pixels from the lower left corner of the view.
struct OutlinePiece
{
  glm::dvec2 from{0.0}, to{0.0};
  bool certain = true;  ///< certainly an edge and visible all along; else it may be
  bool cutFrom = false; ///< it goes on, but not certainly visible: a line may end here square or round
  bool cutTo = false;
};

/// The outline of a scene as lines on the screen: its edges (see findOutlineEdges()), less what is hidden, in
/// double precision and without any graphics. One truth serves every width of line.
///
/// Edges are looked at every quarter of a pixel, by rays from the eye; what lies between two points that are
/// both certainly visible counts as visible. Of an edge outside the view, where no depth is known to anyone
/// who draws, nothing is certain.
class OutlineTruth
{
public:
  /// Whether a line of some width covers the centre of a pixel.
  enum class Line : unsigned char
  {
    No,      ///< farther from all that may be visible than half a pixel outside the line
    Perhaps, ///< anything between
    Yes      ///< within the line of a part that is certainly visible
  };

  /// How far inside a line a pixel centre has to lie to be certainly covered, in pixels.
  static constexpr double lineTolerance = 1.0 / 64.0;

  /// How far from a line a pixel may be coloured, in pixels.
  static constexpr double blankTolerance = 0.5;

  /// @par Cost  some 40 rays a pixel of the outline's length, on all cores
  OutlineTruth(const Scene& scene, const View& view, const OutlineOptions& options = {});

  int width() const { return this->size.x; }
  int height() const { return this->size.y; }

  const std::vector<OutlinePiece>& pieces() const { return this->lines; }

  /// Distance in pixels from the centre of a pixel (row 0 is the lowest) to the nearest part that may be
  /// visible; infinity beyond what widest + 4 has need of.
  double distance(int x, int y) const { return this->possible[this->index(x, y)]; }

  /// The same to the nearest part that is certainly visible, but for where only the round end of a line that
  /// goes on hidden would reach.
  double certainDistance(int x, int y) const { return this->certain[this->index(x, y)]; }

  /// @param lineWidth  pixels, at most OutlineOptions::widest
  Line line(int x, int y, double lineWidth) const;

private:
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * this->size.x + x; }
  void draw(const OutlinePiece& piece, double reach);

  glm::ivec2 size;
  std::vector<OutlinePiece> lines;
  std::vector<double> possible;
  std::vector<double> certain;
};

} // namespace shadow::truth
