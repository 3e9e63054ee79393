// How a ClusterTree is built.
#include "ClusterTree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shadow
{

namespace
{

/// What offsets are stored as: whole numbers up to this. Where one is larger, the node is not bounded.
constexpr double largestOffset = PlaneBlock::unitsInOne;
constexpr std::int16_t unbounded = std::numeric_limits<std::int16_t>::min();

/// Centre of the bounding box of triangles, in units of PlaneBlock.
glm::dvec3 findCentre(std::size_t first, std::size_t end,
                      const std::vector<std::array<std::uint32_t, 3>>& triangles,
                      const std::vector<glm::vec3>& positions, double reach)
{
  glm::dvec3 lower(std::numeric_limits<double>::max());
  glm::dvec3 upper(std::numeric_limits<double>::lowest());
  for (std::size_t triangle = first; triangle < end; ++triangle)
  {
    for (const std::uint32_t vertex : triangles[triangle])
    {
      lower = glm::min(lower, glm::dvec3(positions[vertex]));
      upper = glm::max(upper, glm::dvec3(positions[vertex]));
    }
  }
  return glm::round(0.5 * (lower + upper) * (PlaneBlock::unitsInOne / reach));
}

} // namespace

/// What a node stores, of the planes of all its triangles: in units of PlaneBlock, and as numbers that hold
/// them exactly, but for offsets, which are rounded outwards as they are stored.
struct ClusterTree::Bounds
{
  glm::dvec3 centre{0.0};
  glm::dvec3 normalLower{std::numeric_limits<double>::max()};
  glm::dvec3 normalUpper{std::numeric_limits<double>::lowest()};
  double offsetLower = std::numeric_limits<double>::max();
  double offsetUpper = std::numeric_limits<double>::lowest();

  void add(const PlaneBlock& block, std::size_t bit)
  {
    const glm::dvec4 plane(block.getUnits(bit));
    const glm::dvec3 normal(plane);
    const double offset = plane.w + glm::dot(normal, this->centre) / PlaneBlock::unitsInOne;
    this->normalLower = glm::min(this->normalLower, normal);
    this->normalUpper = glm::max(this->normalUpper, normal);
    this->offsetLower = std::min(this->offsetLower, offset);
    this->offsetUpper = std::max(this->offsetUpper, offset);
  }

  /// Adds what a child bounds. From another centre, its planes pass elsewhere.
  void add(const Bounds& child)
  {
    const glm::dvec3 step = (this->centre - child.centre) / PlaneBlock::unitsInOne;
    const glm::dvec3 first = child.normalLower * step;
    const glm::dvec3 second = child.normalUpper * step;
    const glm::dvec3 lower = glm::min(first, second);
    const glm::dvec3 upper = glm::max(first, second);
    this->normalLower = glm::min(this->normalLower, child.normalLower);
    this->normalUpper = glm::max(this->normalUpper, child.normalUpper);
    this->offsetLower = std::min(this->offsetLower, child.offsetLower + lower.x + lower.y + lower.z);
    this->offsetUpper = std::max(this->offsetUpper, child.offsetUpper + upper.x + upper.y + upper.z);
  }

  /// Nothing is known of the planes: the node never faces a light as one.
  void clear()
  {
    this->normalLower = glm::dvec3(-PlaneBlock::unitsInOne);
    this->normalUpper = glm::dvec3(PlaneBlock::unitsInOne);
    this->offsetLower = std::numeric_limits<double>::lowest();
    this->offsetUpper = std::numeric_limits<double>::max();
  }
};

ClusterTree::ClusterTree(const std::vector<PlaneBlock>& planes, const EdgeTable& edges,
                         const std::vector<std::array<std::uint32_t, 3>>& triangles,
                         const std::vector<glm::vec3>& positions, double reach,
                         const ParallelFor& parallelFor)
    : words(planes.size()), clusters((triangles.size() + PlaneBlock::quarter - 1) / PlaneBlock::quarter)
{
  std::size_t nodes = this->clusters;
  do
  {
    this->levels.emplace_back((nodes + fan - 1) / fan);
    nodes = this->levels.back().size();
  } while (nodes > 1);
  constexpr std::size_t grain = 256; // words; of whole groups
  forRanges(parallelFor, this->words, grain,
            [&](std::size_t begin, std::size_t end)
            {
              for (std::size_t word = begin; word < end; ++word)
              {
                this->boundClusters(word, planes, edges, triangles, positions, reach);
              }
            });
  nodes = this->clusters;
  for (std::size_t level = 1; level < this->levels.size(); ++level)
  {
    nodes = this->boundLevel(level, nodes);
  }
}

/// Of the quarters of one word.
void ClusterTree::boundClusters(std::size_t word, const std::vector<PlaneBlock>& planes, const EdgeTable& edges,
                                const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                const std::vector<glm::vec3>& positions, double reach)
{
  const auto add = [&planes](Bounds& bounds, std::size_t triangle)
  { bounds.add(planes[triangle / PlaneBlock::triangles], triangle % PlaneBlock::triangles); };
  std::array<Bounds, quartersOfWord> ofWord;
  const std::size_t first = quartersOfWord * word;
  const std::size_t end = std::min(first + quartersOfWord, this->clusters);
  for (std::size_t cluster = first; cluster < end; ++cluster)
  {
    const std::size_t begin = PlaneBlock::quarter * cluster;
    const std::size_t behind = std::min(begin + PlaneBlock::quarter, triangles.size());
    Bounds& bounds = ofWord[cluster - first];
    bounds.centre = findCentre(begin, behind, triangles, positions, reach);
    for (std::size_t triangle = begin; triangle < behind; ++triangle)
    {
      add(bounds, triangle);
    }
  }
  // What lies across the edges.
  const EdgeTable::Record record = edges.getRecord(word);
  for (std::size_t inner = 0; inner < record.inner; ++inner)
  {
    add(ofWord[EdgeTable::triangleOf(record.innerFirst[inner]) / PlaneBlock::quarter],
        PlaneBlock::triangles * word + EdgeTable::triangleOf(record.innerSecond[inner]));
  }
  for (std::size_t outer = 0; outer < record.outer; ++outer)
  {
    add(ofWord[EdgeTable::triangleOf(record.outerFirst[outer]) / PlaneBlock::quarter], record.outerSecond[outer]);
  }
  for (std::size_t cluster = first; cluster < end; ++cluster)
  {
    this->store(0, cluster, ofWord[cluster - first]);
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
    bounds.centre = glm::round(bounds.centre);
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
  Bounds stored = bounds;
  const bool fits = bounds.offsetLower >= -largestOffset && bounds.offsetUpper <= largestOffset;
  if (!fits)
  {
    stored.clear();
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    group.centre[axis][lane] = static_cast<std::int16_t>(stored.centre[axis]);
    group.normalLower[axis][lane] = static_cast<std::int16_t>(stored.normalLower[axis]);
    group.normalUpper[axis][lane] = static_cast<std::int16_t>(stored.normalUpper[axis]);
  }
  group.offsetLower[lane] = fits ? static_cast<std::int16_t>(std::floor(stored.offsetLower)) : unbounded;
  group.offsetUpper[lane] = fits ? static_cast<std::int16_t>(std::ceil(stored.offsetUpper))
                                 : std::numeric_limits<std::int16_t>::max();
}

ClusterTree::Bounds ClusterTree::load(std::size_t level, std::size_t node) const
{
  const Group& group = this->levels[level][node / fan];
  const std::size_t lane = node % fan;
  const auto take = [lane](const std::array<Lanes, 3>& lanes)
  { return glm::dvec3(lanes[0][lane], lanes[1][lane], lanes[2][lane]); };
  Bounds bounds = {take(group.centre), take(group.normalLower), take(group.normalUpper),
                   static_cast<double>(group.offsetLower[lane]),
                   static_cast<double>(group.offsetUpper[lane])};
  if (group.offsetLower[lane] == unbounded)
  {
    bounds.clear();
  }
  return bounds;
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
