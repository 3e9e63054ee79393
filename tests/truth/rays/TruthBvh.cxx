#include "TruthBvh.h"

#include <numeric>

namespace shadow::truth
{

namespace
{

constexpr int binCount = 16;

glm::dvec3 middle(const Box& box)
{
  return 0.5 * box.low + 0.5 * box.high;
}

/// Maps a centre to its bin along one axis.
struct Binning
{
  double low, scale;
  int operator()(double centre) const
  {
    return std::clamp(static_cast<int>((centre - this->low) * this->scale), 0, binCount - 1);
  }
};

struct Plane
{
  double cost = std::numeric_limits<double>::infinity();
  int axis = 0;
  int bin = 0; ///< items in this bin and below go left
  Binning binning{0.0, 0.0};
};

struct Bin
{
  Box box;
  std::uint32_t count = 0;
};

/// The cheapest of the binCount - 1 planes across one axis.
Plane cheapestPlane(const std::array<Bin, binCount>& bins, int axis, const Binning& binning)
{
  std::array<double, binCount> rightCost{};
  Bin right;
  for (int i = binCount - 1; i > 0; --i)
  {
    right.box.add(bins[i].box);
    right.count += bins[i].count;
    rightCost[i] =
        right.count > 0 ? right.box.halfArea() * right.count : std::numeric_limits<double>::infinity();
  }
  Plane best;
  Bin left;
  for (int i = 0; i + 1 < binCount; ++i)
  {
    left.box.add(bins[i].box);
    left.count += bins[i].count;
    const double cost = left.box.halfArea() * left.count + rightCost[i + 1];
    if (left.count > 0 && cost < best.cost)
    {
      best = {cost, axis, i, binning};
    }
  }
  return best;
}

} // namespace

TruthBvh::TruthBvh(const std::vector<Box>& boxes) : items(boxes.size())
{
  std::iota(this->items.begin(), this->items.end(), 0u);
  if (boxes.empty())
  {
    return;
  }
  this->nodes.emplace_back();
  std::vector<Range> open{{0, 0, static_cast<std::uint32_t>(boxes.size()), 0}};
  while (!open.empty())
  {
    const Range range = open.back();
    open.pop_back();
    for (std::uint32_t i = range.begin; i < range.end; ++i)
    {
      this->nodes[range.node].box.add(boxes[this->items[i]]);
    }
    if (range.end - range.begin <= leafSize)
    {
      this->nodes[range.node].first = range.begin;
      this->nodes[range.node].count = range.end - range.begin;
      continue;
    }
    const std::uint32_t mid = this->split(boxes, range);
    const auto child = static_cast<std::uint32_t>(this->nodes.size());
    this->nodes[range.node].first = child;
    this->nodes.resize(this->nodes.size() + 2);
    open.push_back({child, range.begin, mid, range.depth + 1});
    open.push_back({child + 1, mid, range.end, range.depth + 1});
  }
}

std::uint32_t TruthBvh::split(const std::vector<Box>& boxes, const Range& range)
{
  Box centres;
  for (std::uint32_t i = range.begin; i < range.end; ++i)
  {
    centres.add(middle(boxes[this->items[i]]));
  }
  const glm::dvec3 size = centres.high - centres.low;
  Plane best;
  for (int axis = 0; axis < 3 && range.depth < heuristicDepth; ++axis)
  {
    const Binning binning{centres.low[axis], binCount / size[axis]};
    if (!std::isfinite(binning.scale))
    {
      continue; // all centres at one coordinate
    }
    std::array<Bin, binCount> bins;
    for (std::uint32_t i = range.begin; i < range.end; ++i)
    {
      const Box& box = boxes[this->items[i]];
      Bin& bin = bins[binning(middle(box)[axis])];
      bin.box.add(box);
      ++bin.count;
    }
    const Plane plane = cheapestPlane(bins, axis, binning);
    best = plane.cost < best.cost ? plane : best;
  }
  if (!std::isfinite(best.cost))
  {
    const int longest = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return this->halve(boxes, range, longest);
  }
  const auto mid = std::partition(this->items.begin() + range.begin, this->items.begin() + range.end,
                                  [&](std::uint32_t item)
                                  { return best.binning(middle(boxes[item])[best.axis]) <= best.bin; });
  return static_cast<std::uint32_t>(mid - this->items.begin());
}

std::uint32_t TruthBvh::halve(const std::vector<Box>& boxes, const Range& range, int axis)
{
  const std::uint32_t mid = range.begin + (range.end - range.begin) / 2;
  std::nth_element(this->items.begin() + range.begin, this->items.begin() + mid,
                   this->items.begin() + range.end,
                   [&](std::uint32_t left, std::uint32_t right)
                   { return middle(boxes[left])[axis] < middle(boxes[right])[axis]; });
  return mid;
}

} // namespace shadow::truth
