#include "TriangleOrder.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "PlaneBlock.h"

namespace shadow
{

namespace
{

constexpr std::size_t patchSize = PlaneBlock::quarter;

struct Item
{
  glm::vec3 centre;
  std::uint32_t triangle;
};

int findWidestAxis(const Item* first, const Item* last)
{
  glm::vec3 lower(std::numeric_limits<float>::max());
  glm::vec3 upper(std::numeric_limits<float>::lowest());
  for (const Item* item = first; item != last; ++item)
  {
    lower = glm::min(lower, item->centre);
    upper = glm::max(upper, item->centre);
  }
  // Halved, as the difference of two large coordinates may overflow.
  const glm::vec3 extent = 0.5f * upper - 0.5f * lower;
  const int wider = extent.y > extent.x ? 1 : 0;
  return extent.z > extent[wider] ? 2 : wider;
}

/// Puts those on one side before those on the other. @return  the first of the second half
Item* halve(Item* first, Item* last)
{
  const auto count = static_cast<std::size_t>(last - first);
  std::size_t half = patchSize;
  while (2 * half < count)
  {
    half *= 2;
  }
  const int axis = findWidestAxis(first, last);
  std::nth_element(first, first + half, last,
                   [axis](const Item& a, const Item& b) {
                     return a.centre[axis] != b.centre[axis] ? a.centre[axis] < b.centre[axis]
                                                             : a.triangle < b.triangle;
                   });
  return first + half;
}

bool isPatch(const Item* first, const Item* last)
{
  return static_cast<std::size_t>(last - first) <= patchSize;
}

void sortRange(Item* first, Item* last)
{
  if (!isPatch(first, last))
  {
    Item* middle = halve(first, last);
    sortRange(first, middle);
    sortRange(middle, last);
  }
}

/// Level by level while ranges are few and long, each range then by itself.
void sortInParallel(std::vector<Item>& items, const ParallelFor& parallelFor)
{
  constexpr std::size_t longest = 1 << 15;
  using Range = std::pair<Item*, Item*>;
  std::vector<Range> ranges = {{items.data(), items.data() + items.size()}};
  for (std::size_t length = items.size(); length > longest; length /= 2)
  {
    std::vector<Range> halves(2 * ranges.size());
    forRanges(parallelFor, ranges.size(), 1,
              [&](std::size_t begin, std::size_t end)
              {
                for (std::size_t range = begin; range < end; ++range)
                {
                  const auto [first, last] = ranges[range];
                  Item* middle = isPatch(first, last) ? last : halve(first, last);
                  halves[2 * range] = {first, middle};
                  halves[2 * range + 1] = {middle, last};
                }
              });
    ranges.swap(halves);
  }
  forRanges(parallelFor, ranges.size(), 1,
            [&ranges](std::size_t begin, std::size_t end)
            {
              for (std::size_t range = begin; range < end; ++range)
              {
                sortRange(ranges[range].first, ranges[range].second);
              }
            });
}

} // namespace

std::vector<std::uint32_t> sortIntoPatches(std::vector<std::array<std::uint32_t, 3>>& triangles,
                                           const std::vector<glm::vec3>& positions,
                                           const ParallelFor& parallelFor)
{
  std::vector<Item> items;
  items.reserve(triangles.size());
  for (const std::array<std::uint32_t, 3>& corners : triangles)
  {
    // Divided before they are added, for the same reason.
    items.push_back(
        {positions[corners[0]] / 3.0f + positions[corners[1]] / 3.0f + positions[corners[2]] / 3.0f,
         static_cast<std::uint32_t>(items.size())});
  }
  sortInParallel(items, parallelFor);
  std::vector<std::uint32_t> order;
  order.reserve(items.size());
  for (const Item& item : items)
  {
    order.push_back(item.triangle);
  }
  putInOrder(triangles, order);
  return order;
}

void putInOrder(std::vector<std::array<std::uint32_t, 3>>& triangles, const std::vector<std::uint32_t>& order)
{
  std::vector<std::array<std::uint32_t, 3>> ordered;
  ordered.reserve(order.size());
  for (const std::uint32_t triangle : order)
  {
    ordered.push_back(triangles[triangle]);
  }
  triangles.swap(ordered);
}

} // namespace shadow
