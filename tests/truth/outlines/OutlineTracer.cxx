#include "OutlineTracer.h"

#include <algorithm>
#include <cmath>

namespace shadow::truth
{

namespace
{

/// Between two looks, in pixels.
constexpr double stride = 0.25;

/// Of an edge's height over the near plane: what is nearer to that plane counts as in front of it.
constexpr double leastHeight = 1e-9;

glm::dvec4 mix(const glm::dvec4& from, const glm::dvec4& to, double at)
{
  return (1.0 - at) * from + at * to;
}

/// Where along from -> to, in clip space, the point lies that is seen at a part of the way on the screen.
double wayInClip(double at, double fromW, double toW)
{
  return at * fromW / ((1.0 - at) * toW + at * fromW);
}

} // namespace

bool OutlineTracer::follow(const OutlineEdge& edge, Track& track) const
{
  track.clipFrom = this->rays.toClip(edge.a);
  track.clipTo = this->rays.toClip(edge.b);
  const double low = std::min(track.clipFrom.z, track.clipTo.z);
  const double high = std::max(track.clipFrom.z, track.clipTo.z);
  const double least = leastHeight * high;
  if (!(high > 0.0))
  {
    return false;
  }
  if (low < least)
  {
    const double at = (least - track.clipFrom.z) / (track.clipTo.z - track.clipFrom.z);
    const bool cutsFrom = track.clipFrom.z < least;
    (cutsFrom ? track.clipFrom : track.clipTo) = mix(track.clipFrom, track.clipTo, at);
    (cutsFrom ? track.wholeFrom : track.wholeTo) = false;
  }
  track.from = this->rays.toPixels(track.clipFrom);
  track.to = this->rays.toPixels(track.clipTo);
  // Liang & Barsky 1984, for the view grown by reach.
  const glm::dvec2 way = track.to - track.from;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double enter = -this->reach - track.from[axis];
    const double leave = this->size[axis] + this->reach - track.from[axis];
    if (way[axis] == 0.0)
    {
      if (enter > 0.0 || leave < 0.0)
      {
        return false;
      }
      continue;
    }
    track.first = std::max(track.first, (way[axis] > 0.0 ? enter : leave) / way[axis]);
    track.last = std::min(track.last, (way[axis] > 0.0 ? leave : enter) / way[axis]);
  }
  return track.first < track.last || (track.first == track.last && glm::length(way) == 0.0);
}

bool OutlineTracer::isHidden(const OutlineEdge& edge, const glm::dvec2& pixel, double height) const
{
  const Ray ray = this->rays.through(pixel.x, pixel.y);
  const glm::dvec3 point = this->rays.atHeight(ray, height);
  const double rounding = vertexRounding(
      std::max(largestCoordinate(point + this->caster.originWC()), largestCoordinate(ray.origin)));
  return this->caster.isCovered(point, rounding, ray, edge.triangles);
}

bool OutlineTracer::seesEdgeOf(const OutlineEdge& edge, const glm::dvec2& pixel) const
{
  const std::optional<Hit> hit = this->caster.firstHit(this->rays.through(pixel.x, pixel.y));
  return hit && (hit->triangle == edge.triangles[0] || hit->triangle == edge.triangles[1]);
}

OutlineTracer::Sight OutlineTracer::look(const OutlineEdge& edge, const Track& track, double at) const
{
  const glm::dvec2 pixel = glm::mix(track.from, track.to, at);
  if (pixel.x < 0.0 || pixel.y < 0.0 || pixel.x > this->size.x || pixel.y > this->size.y)
  {
    return Sight::Perhaps;
  }
  const double height = mix(track.clipFrom, track.clipTo, wayInClip(at, track.clipFrom.w, track.clipTo.w)).z;
  const bool hidden = this->isHidden(edge, pixel, height);
  const glm::dvec2 way = track.to - track.from;
  if (glm::length(way) == 0.0)
  {
    return hidden ? Sight::Hidden : Sight::Visible;
  }
  const glm::dvec2 ahead = glm::normalize(way);
  const glm::dvec2 right(ahead.y, -ahead.x);
  if (hidden)
  {
    for (const double side : {1.0, -1.0})
    {
      const glm::dvec2 beside = pixel + side * this->offsets.hidden * right;
      const bool isOutside = side * edge.inside > 0.0;
      if (this->seesEdgeOf(edge, beside) || (isOutside && !this->isHidden(edge, beside, height)))
      {
        return Sight::Perhaps;
      }
    }
    return Sight::Hidden;
  }
  for (const double along : {0.0, -1.0, 1.0})
  {
    const glm::dvec2 outwards = static_cast<double>(edge.inside) * right + along * ahead;
    if (edge.inside != 0 && this->isHidden(edge, pixel + this->offsets.visible * outwards, height))
    {
      return Sight::Perhaps;
    }
  }
  return Sight::Visible;
}

void OutlineTracer::trace(const OutlineEdge& edge, std::vector<OutlinePiece>& pieces) const
{
  Track track;
  if (!this->follow(edge, track))
  {
    return;
  }
  const double length = (track.last - track.first) * glm::distance(track.from, track.to);
  const int steps = std::max(1, static_cast<int>(std::ceil(length / stride)));
  const auto at = [&](int step) { return track.first + (track.last - track.first) * step / steps; };
  // At an edge's very ends what is beside it may be the surface of the next edge.
  const double inwards = std::min(0.25, 3.0 * this->offsets.visible / glm::distance(track.from, track.to));
  const auto lookAt = [&](int step)
  {
    const double least = track.wholeFrom ? inwards : 0.0;
    const double most = track.wholeTo ? 1.0 - inwards : 1.0;
    return this->look(edge, track, std::clamp(at(step), least, most));
  };
  const auto pixelAt = [&](int step) { return glm::mix(track.from, track.to, at(step)); };

  Sight before = lookAt(0);
  Sight state = Sight::Hidden; ///< of the steps since begin
  int begin = 0;
  const auto finish = [&](int end)
  {
    if (state != Sight::Hidden)
    {
      const bool cutFrom = begin > 0 || !track.wholeFrom || track.first > 0.0;
      const bool cutTo = end < steps || !track.wholeTo || track.last < 1.0;
      pieces.push_back({pixelAt(begin), pixelAt(end), state == Sight::Visible, cutFrom, cutTo});
    }
  };
  for (int step = 0; step < steps; ++step)
  {
    const Sight after = lookAt(step + 1);
    const Sight between = before != after || before == Sight::Perhaps ? Sight::Perhaps
                          : before == Sight::Visible && !edge.certain ? Sight::Perhaps
                                                                      : before;
    if (step > 0 && between != state)
    {
      finish(step);
      begin = step;
    }
    state = between;
    before = after;
  }
  finish(steps);
}

} // namespace shadow::truth
