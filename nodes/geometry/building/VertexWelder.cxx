#include "VertexWelder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

namespace shadow
{

namespace
{

constexpr std::uint32_t emptySlot = std::numeric_limits<std::uint32_t>::max();

/// Spreads the bits of three words over one (multiply and fold; the constants are odd and have no structure).
std::uint64_t mix(std::uint64_t a, std::uint64_t b, std::uint64_t c)
{
  std::uint64_t hash = (a ^ (b << 32 | b >> 32)) * 0x9E3779B97F4A7C15ull;
  hash = (hash ^ (hash >> 29) ^ c) * 0xBF58476D1CE4E5B9ull;
  hash ^= hash >> 32;
  hash *= 0x94D049BB133111EBull;
  return hash ^ (hash >> 29);
}

std::uint64_t hashPosition(const glm::vec3& position)
{
  std::array<std::uint32_t, 3> bits;
  std::memcpy(bits.data(), &position[0], sizeof(bits));
  return mix(bits[0], bits[1], bits[2]);
}

std::uint64_t hashCell(const glm::dvec3& cell)
{
  std::array<std::uint64_t, 3> bits;
  std::memcpy(bits.data(), &cell[0], sizeof(bits));
  return mix(bits[0], bits[1], bits[2]);
}

/// Adding +0 turns -0 into +0 and changes nothing else, so that equal coordinates have equal bits.
glm::vec3 relativePosition(const glm::dvec3& point, const glm::dvec3& origin)
{
  return glm::vec3(point - origin) + 0.0f;
}

std::size_t tableSize(std::size_t entries)
{
  std::size_t size = 16;
  while (size < entries + entries / 2)
  {
    size *= 2;
  }
  return size;
}

/// Open addressing, keyed by the exact bits of a position.
class ExactTable
{
public:
  ExactTable(std::size_t entries, std::vector<glm::vec3>& welded)
      : slots(tableSize(entries), emptySlot), positions(welded)
  {
  }

  std::uint32_t findOrAdd(const glm::vec3& position)
  {
    const std::size_t mask = this->slots.size() - 1;
    for (std::size_t slot = hashPosition(position) & mask;; slot = (slot + 1) & mask)
    {
      const std::uint32_t vertex = this->slots[slot];
      if (vertex == emptySlot)
      {
        this->slots[slot] = static_cast<std::uint32_t>(this->positions.size());
        this->positions.push_back(position);
        return this->slots[slot];
      }
      if (this->positions[vertex] == position)
      {
        return vertex;
      }
    }
  }

private:
  std::vector<std::uint32_t> slots;
  std::vector<glm::vec3>& positions;
};

/// Hash of cubic cells, each a chain of vertices. Two cells may share a chain: what counts is the distance.
/// Cells are so much wider than the tolerance that most points have all others within it in one to four.
class CellTable
{
public:
  CellTable(std::size_t entries, double theTolerance, std::vector<glm::vec3>& welded)
      : heads(tableSize(entries), emptySlot), tolerance(theTolerance), positions(welded)
  {
  }

  std::uint32_t findOrAdd(const glm::vec3& position)
  {
    const glm::dvec3 cell = this->cellOf(glm::dvec3(position));
    const double reach = 1.0001 * this->tolerance;
    const glm::dvec3 low = this->cellOf(glm::dvec3(position) - reach);
    const glm::dvec3 high = this->cellOf(glm::dvec3(position) + reach);
    std::uint32_t found = emptySlot;
    for (double x = low.x; x <= high.x; ++x)
    {
      for (double y = low.y; y <= high.y; ++y)
      {
        for (double z = low.z; z <= high.z; ++z)
        {
          found = std::min(found, this->findEarliest({x, y, z}, position));
        }
      }
    }
    if (found == emptySlot)
    {
      found = static_cast<std::uint32_t>(this->positions.size());
      this->positions.push_back(position);
      std::uint32_t& head = this->heads[this->slotOf(cell)];
      this->nexts.push_back(head);
      head = found;
    }
    return found;
  }

private:
  static constexpr double cellWidth = 4.0; ///< tolerances

  glm::dvec3 cellOf(const glm::dvec3& position) const
  {
    return glm::floor(position / (cellWidth * this->tolerance));
  }

  std::size_t slotOf(const glm::dvec3& cell) const { return hashCell(cell + 0.0) & (this->heads.size() - 1); }

  std::uint32_t findEarliest(const glm::dvec3& cell, const glm::vec3& position) const
  {
    std::uint32_t earliest = emptySlot;
    for (std::uint32_t vertex = this->heads[this->slotOf(cell)]; vertex != emptySlot;
         vertex = this->nexts[vertex])
    {
      const glm::dvec3 apart = glm::dvec3(this->positions[vertex]) - glm::dvec3(position);
      if (this->positions[vertex] == position || glm::length(apart) < this->tolerance)
      {
        earliest = std::min(earliest, vertex);
      }
    }
    return earliest;
  }

  std::vector<std::uint32_t> heads;
  std::vector<std::uint32_t> nexts;
  double tolerance;
  std::vector<glm::vec3>& positions;
};

template <typename Table>
void weldThrough(Table& table, const std::vector<glm::dvec3>& points, const std::vector<std::uint8_t>& wanted,
                 const glm::dvec3& origin, std::vector<std::uint32_t>& vertexOf)
{
  for (std::size_t point = 0; point < points.size(); ++point)
  {
    if (wanted[point])
    {
      vertexOf[point] = table.findOrAdd(relativePosition(points[point], origin));
    }
  }
}

/// Cell numbers must be exact in double precision, or neighbours could not be found. Tolerances that break
/// this are below the spacing of float32 positions of the same size.
bool isToleranceUsable(const std::vector<glm::dvec3>& points, const std::vector<std::uint8_t>& wanted,
                       const glm::dvec3& origin, double tolerance)
{
  if (!(tolerance > 0.0))
  {
    return false;
  }
  double extent = 0.0;
  for (std::size_t point = 0; point < points.size(); ++point)
  {
    if (wanted[point])
    {
      const glm::dvec3 offset = glm::abs(points[point] - origin);
      extent = std::max({extent, offset.x, offset.y, offset.z});
    }
  }
  return tolerance > extent * 0x1p-48;
}

} // namespace

WeldedPoints weldPoints(const std::vector<glm::dvec3>& points, const std::vector<std::uint8_t>& wanted,
                        const glm::dvec3& origin, double tolerance, std::size_t sizeHint)
{
  WeldedPoints result;
  result.vertexOf.resize(points.size());
  result.positions.reserve(sizeHint);
  const auto entries = static_cast<std::size_t>(
      std::count_if(wanted.begin(), wanted.end(), [](std::uint8_t w) { return w != 0; }));
  if (isToleranceUsable(points, wanted, origin, tolerance))
  {
    CellTable table(entries, tolerance, result.positions);
    weldThrough(table, points, wanted, origin, result.vertexOf);
  }
  else
  {
    ExactTable table(entries, result.positions);
    weldThrough(table, points, wanted, origin, result.vertexOf);
  }
  return result;
}

} // namespace shadow
