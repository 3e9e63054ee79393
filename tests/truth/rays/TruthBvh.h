#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <glm/glm.hpp>

namespace shadow::truth
{

struct Box
{
  glm::dvec3 low{std::numeric_limits<double>::infinity()};
  glm::dvec3 high{-std::numeric_limits<double>::infinity()};

  void add(const glm::dvec3& p)
  {
    this->low = glm::min(this->low, p);
    this->high = glm::max(this->high, p);
  }
  void add(const Box& box)
  {
    this->low = glm::min(this->low, box.low);
    this->high = glm::max(this->high, box.high);
  }
  double halfArea() const
  {
    const glm::dvec3 size = glm::max(this->high - this->low, glm::dvec3(0.0));
    return size.x * size.y + size.y * size.z + size.z * size.x;
  }
};

/// Bounding volume hierarchy over boxes: binned surface area heuristic, flat array, children side by side.
///
/// @par Cost    build O(n log n)
/// @par Source  Wald 2007, "On fast Construction of SAH-based Bounding Volume Hierarchies"
class TruthBvh
{
public:
  TruthBvh() = default;
  explicit TruthBvh(const std::vector<Box>& boxes);

  /// The boxes in leaf order: traverse() speaks of positions in this array.
  const std::vector<std::uint32_t>& order() const { return this->items; }

  /// Calls visit(position) for every box that origin + t direction, 0 <= t <= farthest, may meet, roughly
  /// front to back. visit may lower farthest; it returns true to end the walk.
  template <class Visit>
  void traverse(const glm::dvec3& origin, const glm::dvec3& direction, const double& farthest,
                Visit&& visit) const;

private:
  struct Node
  {
    Box box;
    std::uint32_t first = 0; ///< left child, or first item of a leaf
    std::uint32_t count = 0; ///< items of a leaf; 0: inner node
  };
  struct Range
  {
    std::uint32_t node, begin, end;
    int depth;
  };

  /// Beyond this depth ranges are halved, so that no input makes the tree deeper than stackSize.
  static constexpr int heuristicDepth = 48;
  static constexpr int stackSize = heuristicDepth + 34;
  static constexpr std::uint32_t leafSize = 4;

  std::uint32_t split(const std::vector<Box>& boxes, const Range& range);
  std::uint32_t halve(const std::vector<Box>& boxes, const Range& range, int axis);

  std::vector<Node> nodes;
  std::vector<std::uint32_t> items;
};

/// Distance at which the ray enters the box; infinity when it misses it.
inline double entryDistance(const Box& box, const glm::dvec3& origin, const glm::dvec3& inverse,
                            double farthest)
{
  const glm::dvec3 t0 = (box.low - origin) * inverse;
  const glm::dvec3 t1 = (box.high - origin) * inverse;
  const glm::dvec3 in = glm::min(t0, t1);
  const glm::dvec3 out = glm::max(t0, t1);
  const double enter = std::max(std::max(in.x, in.y), std::max(in.z, 0.0));
  const double leave = std::min(std::min(out.x, out.y), std::min(out.z, farthest));
  // A few roundings of slack, or flat boxes could be missed.
  return enter <= leave * (1.0 + 8.0 * std::numeric_limits<double>::epsilon())
             ? enter
             : std::numeric_limits<double>::infinity();
}

template <class Visit>
void TruthBvh::traverse(const glm::dvec3& origin, const glm::dvec3& direction, const double& farthest,
                        Visit&& visit) const
{
  if (this->nodes.empty())
  {
    return;
  }
  glm::dvec3 inverse;
  for (int axis = 0; axis < 3; ++axis)
  {
    // Finite for a direction along an axis, so that 0 * inverse is not NaN on the face of a box.
    constexpr double least = 1e-300;
    const double d = direction[axis];
    inverse[axis] = 1.0 / (std::abs(d) < least ? std::copysign(least, d) : d);
  }
  constexpr double missed = std::numeric_limits<double>::infinity();
  std::array<std::pair<std::uint32_t, double>, stackSize> stack;
  int top = 0;
  stack[top++] = {0, entryDistance(this->nodes[0].box, origin, inverse, farthest)};
  while (top > 0)
  {
    const auto [index, entry] = stack[--top];
    if (entry == missed || entry > farthest)
    {
      continue;
    }
    const Node& node = this->nodes[index];
    for (std::uint32_t i = 0; i < node.count; ++i)
    {
      if (visit(node.first + i))
      {
        return;
      }
    }
    if (node.count == 0)
    {
      const double left = entryDistance(this->nodes[node.first].box, origin, inverse, farthest);
      const double right = entryDistance(this->nodes[node.first + 1].box, origin, inverse, farthest);
      const std::uint32_t nearer = left <= right ? 0 : 1;
      stack[top++] = {node.first + 1 - nearer, std::max(left, right)};
      stack[top++] = {node.first + nearer, std::min(left, right)};
    }
  }
}

} // namespace shadow::truth
