#include "TriangleOrder.h"

#include <algorithm>
#include <cstddef>
#include <limits>

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

void sortRange(Item* first, Item* last)
{
  const auto count = static_cast<std::size_t>(last - first);
  if (count <= patchSize)
  {
    return;
  }
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
  sortRange(first, first + half);
  sortRange(first + half, last);
}

} // namespace

std::vector<std::uint32_t> sortIntoPatches(std::vector<std::array<std::uint32_t, 3>>& triangles,
                                           const std::vector<glm::vec3>& positions)
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
  sortRange(items.data(), items.data() + items.size());
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
