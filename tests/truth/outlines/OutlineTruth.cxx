#include "OutlineTruth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "OutlineTracer.h"
#include "ParallelRows.h"

namespace shadow::truth
{

namespace
{

/// Edges that a thread takes at a time.
constexpr int edgesAPart = 64;

/// How far beyond the rim of the widest line distances are known, in pixels.
constexpr double margin = 4.0;

/// Long lines are drawn in parts of so many pixels, whose boxes are small.
constexpr double partLength = 16.0;

struct Foot
{
  double at;       ///< of the way from -> to, not clamped
  double distance; ///< to the nearest point of the line
};

Foot findFoot(const glm::dvec2& point, const glm::dvec2& from, const glm::dvec2& to)
{
  const glm::dvec2 way = to - from;
  const double square = glm::dot(way, way);
  const double at = square > 0.0 ? glm::dot(point - from, way) / square : 0.0;
  return {at, glm::distance(point, from + std::clamp(at, 0.0, 1.0) * way)};
}

std::vector<OutlinePiece> traceEdges(const std::vector<OutlineEdge>& edges, const OutlineTracer& tracer)
{
  const int parts = (static_cast<int>(edges.size()) + edgesAPart - 1) / edgesAPart;
  std::vector<std::vector<OutlinePiece>> found(parts);
  forEachRow(parts,
             [&](int part)
             {
               const std::size_t end = std::min<std::size_t>(edges.size(), edgesAPart * (part + 1));
               for (std::size_t edge = edgesAPart * part; edge < end; ++edge)
               {
                 tracer.trace(edges[edge], found[part]);
               }
             });
  std::vector<OutlinePiece> pieces;
  for (const std::vector<OutlinePiece>& some : found)
  {
    pieces.insert(pieces.end(), some.begin(), some.end());
  }
  return pieces;
}

} // namespace

OutlineTruth::OutlineTruth(const Scene& scene, const View& view, const OutlineOptions& options)
    : size(std::max(view.width, 0), std::max(view.height, 0)),
      possible(static_cast<std::size_t>(size.x) * size.y, std::numeric_limits<double>::infinity()),
      certain(possible)
{
  const double reach = 0.5 * options.widest + margin;
  const RayCaster caster(scene);
  const PixelRays rays(view, caster.originWC());
  const OutlineTracer tracer(caster, rays, view, options.offsets, reach);
  this->lines = traceEdges(findOutlineEdges(scene, rays, caster.originWC(), options.creaseDegrees), tracer);
  for (const OutlinePiece& piece : this->lines)
  {
    const int parts =
        std::max(1, static_cast<int>(std::ceil(glm::distance(piece.from, piece.to) / partLength)));
    for (int part = 0; part < parts; ++part)
    {
      OutlinePiece some = piece;
      some.from = glm::mix(piece.from, piece.to, static_cast<double>(part) / parts);
      some.to = glm::mix(piece.from, piece.to, static_cast<double>(part + 1) / parts);
      some.cutFrom = piece.cutFrom && part == 0;
      some.cutTo = piece.cutTo && part + 1 == parts;
      this->draw(some, reach);
    }
  }
}

void OutlineTruth::draw(const OutlinePiece& piece, double reach)
{
  const glm::dvec2 low = glm::min(piece.from, piece.to) - reach;
  const glm::dvec2 high = glm::max(piece.from, piece.to) + reach;
  const glm::ivec2 first = glm::max(glm::ivec2(glm::floor(low)), 0);
  const glm::ivec2 last = glm::min(glm::ivec2(glm::ceil(high)), this->size - 1);
  for (int y = first.y; y <= last.y; ++y)
  {
    for (int x = first.x; x <= last.x; ++x)
    {
      const Foot foot = findFoot({x + 0.5, y + 0.5}, piece.from, piece.to);
      if (foot.distance <= reach)
      {
        double& nearest = this->possible[this->index(x, y)];
        nearest = std::min(nearest, foot.distance);
        const bool beyondCut = (piece.cutFrom && foot.at < 0.0) || (piece.cutTo && foot.at > 1.0);
        if (piece.certain && !beyondCut)
        {
          double& nearestCertain = this->certain[this->index(x, y)];
          nearestCertain = std::min(nearestCertain, foot.distance);
        }
      }
    }
  }
}

OutlineTruth::Line OutlineTruth::line(int x, int y, double lineWidth) const
{
  if (this->certainDistance(x, y) <= 0.5 * lineWidth - lineTolerance)
  {
    return Line::Yes;
  }
  return this->distance(x, y) > 0.5 * lineWidth + blankTolerance ? Line::No : Line::Perhaps;
}

} // namespace shadow::truth
