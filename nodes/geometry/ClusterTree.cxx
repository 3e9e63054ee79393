#include "ClusterTree.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "Prefetch.h"

// Two copies of a function, of which the one that suits the processor is taken at run time.
#if defined(__GNUC__) && defined(__x86_64__) && defined(__linux__)
#define SHADOW_ALSO_FOR_AVX2 __attribute__((target_clones("avx2", "default")))
#else
#define SHADOW_ALSO_FOR_AVX2
#endif

namespace shadow
{

/// What a node stores, in double precision: of the planes of all its triangles.
struct ClusterTree::Bounds
{
  glm::dvec3 centre{0.0};
  glm::dvec3 normalLower{std::numeric_limits<double>::max()};
  glm::dvec3 normalUpper{std::numeric_limits<double>::lowest()};
  double offsetLower = std::numeric_limits<double>::max();
  double offsetUpper = std::numeric_limits<double>::lowest();

  void add(const PlaneBlock& block, std::size_t bit)
  {
    const glm::dvec4 plane = block.get(bit);
    const glm::dvec3 normal(plane);
    const double offset = plane.w + glm::dot(normal, this->centre);
    this->normalLower = glm::min(this->normalLower, normal);
    this->normalUpper = glm::max(this->normalUpper, normal);
    this->offsetLower = std::min(this->offsetLower, offset);
    this->offsetUpper = std::max(this->offsetUpper, offset);
  }

  /// Adds what a child bounds. From another centre, its planes pass elsewhere.
  void add(const Bounds& child)
  {
    const glm::dvec3 step = this->centre - child.centre;
    const glm::dvec3 first = child.normalLower * step;
    const glm::dvec3 second = child.normalUpper * step;
    const glm::dvec3 lower = glm::min(first, second);
    const glm::dvec3 upper = glm::max(first, second);
    this->normalLower = glm::min(this->normalLower, child.normalLower);
    this->normalUpper = glm::max(this->normalUpper, child.normalUpper);
    this->offsetLower = std::min(this->offsetLower, child.offsetLower + lower.x + lower.y + lower.z);
    this->offsetUpper = std::max(this->offsetUpper, child.offsetUpper + upper.x + upper.y + upper.z);
  }
};

/// One call of classify(). Words that face alike one after the other are written together.
struct ClusterTree::Walk
{
  const ScaledLight& light;
  std::uint64_t* towards;
  std::uint64_t* away;
  std::size_t runBegin = 0;
  std::size_t runEnd = 0;
  bool runTowards = false;

  void add(std::size_t first, std::size_t end, bool isTowards)
  {
    if (first != this->runEnd || isTowards != this->runTowards)
    {
      this->flush();
      this->runBegin = first;
      this->runTowards = isTowards;
    }
    this->runEnd = end;
  }

  void flush() const
  {
    const std::size_t count = this->runEnd - this->runBegin;
    std::memset(this->towards + this->runBegin, this->runTowards ? 0xff : 0, 8 * count);
    std::memset(this->away + this->runBegin, this->runTowards ? 0 : 0xff, 8 * count);
  }
};

namespace
{

float roundDown(double value)
{
  const auto rounded = static_cast<float>(value);
  return static_cast<double>(rounded) <= value
             ? rounded
             : std::nextafter(rounded, -std::numeric_limits<float>::infinity());
}

float roundUp(double value)
{
  return -roundDown(-value);
}

/// Centre of the bounding box of a word's triangles, in units of the reach, as it will be stored.
glm::dvec3 findCentre(std::size_t first, std::size_t end,
                      const std::vector<std::array<std::uint32_t, 3>>& triangles,
                      const std::vector<glm::vec3>& positions, double reach)
{
  glm::vec3 lower(std::numeric_limits<float>::max());
  glm::vec3 upper(std::numeric_limits<float>::lowest());
  for (std::size_t triangle = first; triangle < end; ++triangle)
  {
    for (const std::uint32_t vertex : triangles[triangle])
    {
      lower = glm::min(lower, positions[vertex]);
      upper = glm::max(upper, positions[vertex]);
    }
  }
  return glm::dvec3(glm::vec3((0.5 * glm::dvec3(lower) + 0.5 * glm::dvec3(upper)) / reach));
}

} // namespace

ClusterTree::ClusterTree(const std::vector<PlaneBlock>& planes, const EdgeTable& edges,
                         const std::vector<std::array<std::uint32_t, 3>>& triangles,
                         const std::vector<glm::vec3>& positions, double reach)
    : words(planes.size())
{
  std::size_t nodes = this->words;
  do
  {
    this->levels.emplace_back((nodes + fan - 1) / fan);
    nodes = this->levels.back().size();
  } while (nodes > 1);

  for (std::size_t word = 0; word < this->words; ++word)
  {
    const std::size_t count = std::min<std::size_t>(64, triangles.size() - 64 * word);
    Bounds bounds;
    bounds.centre = findCentre(64 * word, 64 * word + count, triangles, positions, reach);
    for (std::size_t bit = 0; bit < count; ++bit)
    {
      bounds.add(planes[word], bit);
    }
    const EdgeTable::Record record = edges.getRecord(word);
    for (std::size_t outer = 0; outer < record.outer; ++outer)
    {
      const std::uint32_t triangle = record.outerSecond[outer];
      bounds.add(planes[triangle >> 6], triangle & 63u);
    }
    this->store(0, word, bounds);
  }
  nodes = this->words;
  for (std::size_t level = 1; level < this->levels.size(); ++level)
  {
    nodes = this->boundLevel(level, nodes);
  }
}

/// Bounds the nodes of a level by their children. @return  how many nodes there are
std::size_t ClusterTree::boundLevel(std::size_t level, std::size_t children)
{
  const std::size_t nodes = (children + fan - 1) / fan;
  for (std::size_t node = 0; node < nodes; ++node)
  {
    const std::size_t end = std::min(fan * node + fan, children);
    Bounds bounds;
    for (std::size_t child = fan * node; child < end; ++child)
    {
      bounds.centre += this->load(level - 1, child).centre / static_cast<double>(end - fan * node);
    }
    bounds.centre = glm::dvec3(glm::vec3(bounds.centre));
    for (std::size_t child = fan * node; child < end; ++child)
    {
      bounds.add(this->load(level - 1, child));
    }
    this->store(level, node, bounds);
  }
  return nodes;
}

void ClusterTree::store(std::size_t level, std::size_t node, const Bounds& bounds)
{
  Group& group = this->levels[level][node / fan];
  const std::size_t lane = node % fan;
  for (int axis = 0; axis < 3; ++axis)
  {
    group.centre[axis][lane] = static_cast<float>(bounds.centre[axis]);
    group.normalLower[axis][lane] = roundDown(bounds.normalLower[axis]);
    group.normalUpper[axis][lane] = roundUp(bounds.normalUpper[axis]);
  }
  group.offsetLower[lane] = roundDown(bounds.offsetLower);
  group.offsetUpper[lane] = roundUp(bounds.offsetUpper);
}

ClusterTree::Bounds ClusterTree::load(std::size_t level, std::size_t node) const
{
  const Group& group = this->levels[level][node / fan];
  const std::size_t lane = node % fan;
  const auto take = [lane](const std::array<Lanes, 3>& lanes)
  { return glm::dvec3(lanes[0][lane], lanes[1][lane], lanes[2][lane]); };
  return {take(group.centre), take(group.normalLower), take(group.normalUpper), group.offsetLower[lane],
          group.offsetUpper[lane]};
}

void ClusterTree::classify(const ScaledLight& light, FacingBits& towards, FacingBits& away,
                           std::vector<std::uint32_t>& mixed) const
{
  if (this->words == 0)
  {
    return;
  }
  // Level by level, since what is next on a level is known, and fetched, before its turn.
  constexpr std::size_t ahead = 4;
  Walk walk{light, towards.data(), away.data()};
  std::vector<std::uint32_t> groups = {0};
  std::vector<std::uint32_t> below;
  for (std::size_t level = this->levels.size(); level-- > 0;)
  {
    std::vector<std::uint32_t>& next = level > 0 ? below : mixed;
    for (std::size_t index = 0; index < groups.size(); ++index)
    {
      if (index + ahead < groups.size())
      {
        prefetch(&this->levels[level][groups[index + ahead]], sizeof(Group));
      }
      this->visit(level, groups[index], walk, next);
    }
    groups.swap(below);
    below.clear();
  }
  walk.flush();
  towards.clearBeyondEnd();
  away.clearBeyondEnd();
}

/// Bounds of what the planes of eight nodes give at a light.
SHADOW_ALSO_FOR_AVX2 void ClusterTree::evaluate(const Group& nodes, const ScaledLight& light, Lanes& lower,
                                                Lanes& upper)
{
  for (std::size_t lane = 0; lane < fan; ++lane)
  {
    const float first = nodes.offsetLower[lane] * light.w;
    const float second = nodes.offsetUpper[lane] * light.w;
    lower[lane] = std::min(first, second);
    upper[lane] = std::max(first, second);
  }
  const std::array<float, 3> towards = {light.x, light.y, light.z};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (std::size_t lane = 0; lane < fan; ++lane)
    {
      const float arm = towards[axis] - light.w * nodes.centre[axis][lane];
      const float first = nodes.normalLower[axis][lane] * arm;
      const float second = nodes.normalUpper[axis][lane] * arm;
      lower[lane] += std::min(first, second);
      upper[lane] += std::max(first, second);
    }
  }
}

/// Writes the words of a group's children that face alike.
/// @param mixed  the other children are appended, by their number on their level
void ClusterTree::visit(std::size_t level, std::size_t group, Walk& walk,
                        std::vector<std::uint32_t>& mixed) const
{
  // With u, e and S as in ScaledLight: the planes are off by (u / 2 + 1 e) S, the light by 1 e S, relative to
  // the centre by 3 e S, evaluating adds 6 e (|x| + |y| + |z| + 3 |w|), as offsets are below 2; and a corner
  // at the light is within 1 e S. The sum is below (u / 2 + 27 e) S, which is 283 e S, and the bound for one
  // plane 272 e S.
  const float bound = 1.125f * walk.light.bound;
  Lanes lower{};
  Lanes upper{};
  evaluate(this->levels[level][group], walk.light, lower, upper);

  std::size_t span = 1; // words of a child
  for (std::size_t below = 0; below < level; ++below)
  {
    span *= fan;
  }
  const std::size_t covered = std::min(this->words - fan * span * group, fan * span);
  const std::size_t children = (covered + span - 1) / span;
  for (std::size_t lane = 0; lane < children; ++lane)
  {
    const std::size_t child = fan * group + lane;
    if (lower[lane] > bound || upper[lane] < -bound)
    {
      walk.add(child * span, std::min((child + 1) * span, this->words), lower[lane] > bound);
    }
    else
    {
      mixed.push_back(static_cast<std::uint32_t>(child));
    }
  }
}

std::size_t ClusterTree::getMemorySize() const
{
  std::size_t bytes = 0;
  for (const std::vector<Group>& level : this->levels)
  {
    bytes += level.capacity() * sizeof(Group);
  }
  return bytes;
}

} // namespace shadow
