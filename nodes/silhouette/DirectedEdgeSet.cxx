#include "DirectedEdgeSet.h"

#include <utility>

namespace shadow
{

namespace
{

constexpr unsigned firstBits = 6;

} // namespace

DirectedEdgeSet::DirectedEdgeSet() : slots(std::size_t{1} << firstBits, Slot{0, 0}), shift(64 - firstBits) {}

void DirectedEdgeSet::add(std::uint32_t from, std::uint32_t to)
{
  const bool upwards = from < to;
  const std::uint64_t vertices = upwards ? std::uint64_t{from} << 32 | to : std::uint64_t{to} << 32 | from;
  const std::size_t mask = this->slots.size() - 1;
  std::size_t index = this->home(vertices);
  while (this->slots[index].vertices != vertices)
  {
    if (this->slots[index].vertices == 0)
    {
      this->slots[index] = {vertices, upwards ? 1 : -1};
      if (2 * ++this->used > this->slots.size())
      {
        this->grow();
      }
      return;
    }
    index = (index + 1) & mask;
  }
  this->slots[index].runs += upwards ? 1 : -1;
  if (this->slots[index].runs == 0)
  {
    this->erase(index);
  }
}

/// Moves up what the hole would cut off from its home.
void DirectedEdgeSet::erase(std::size_t hole)
{
  const std::size_t mask = this->slots.size() - 1;
  for (std::size_t index = (hole + 1) & mask; this->slots[index].vertices != 0; index = (index + 1) & mask)
  {
    const std::size_t fromHome = (index - this->home(this->slots[index].vertices)) & mask;
    if (fromHome >= ((index - hole) & mask))
    {
      this->slots[hole] = this->slots[index];
      hole = index;
    }
  }
  this->slots[hole] = {0, 0};
  --this->used;
}

void DirectedEdgeSet::grow()
{
  std::vector<Slot> old(2 * this->slots.size(), Slot{0, 0});
  std::swap(old, this->slots);
  --this->shift;
  const std::size_t mask = this->slots.size() - 1;
  for (const Slot& slot : old)
  {
    if (slot.vertices != 0)
    {
      std::size_t index = this->home(slot.vertices);
      while (this->slots[index].vertices != 0)
      {
        index = (index + 1) & mask;
      }
      this->slots[index] = slot;
    }
  }
}

std::vector<SilhouetteEdge> DirectedEdgeSet::getEdges() const
{
  std::vector<SilhouetteEdge> edges;
  edges.reserve(this->used);
  for (const Slot& slot : this->slots)
  {
    if (slot.vertices != 0)
    {
      const auto lower = static_cast<std::uint32_t>(slot.vertices >> 32);
      const auto upper = static_cast<std::uint32_t>(slot.vertices);
      const bool upwards = slot.runs > 0;
      edges.push_back({upwards ? lower : upper, upwards ? upper : lower,
                       static_cast<std::uint32_t>(upwards ? slot.runs : -slot.runs)});
    }
  }
  return edges;
}

} // namespace shadow
