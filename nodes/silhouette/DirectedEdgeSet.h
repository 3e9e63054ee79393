#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ShadowVolume.h"

namespace shadow
{

/// The list S of the triangular algorithm, as a hash table: directed edges of which opposite ones cancel.
///
/// While the triangles of a mesh go through it, it holds the boundary of those that have been, so that it
/// stays small however large the mesh is.
///
/// @par Source  Kolivand & Sunar 2011, chapter IV; linear probing with backward-shift deletion, Knuth, "The
///              Art of Computer Programming", volume 3, algorithm 6.4R
class DirectedEdgeSet
{
public:
  DirectedEdgeSet();

  /// Takes out to -> from if it is there, else puts in from -> to. @pre from != to
  ///
  /// @par Cost  O(1) on average
  void add(std::uint32_t from, std::uint32_t to);

  /// Adds the three edges of a triangle.
  void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c)
  {
    this->add(a, b);
    this->add(b, c);
    this->add(c, a);
  }

  /// What is in the set, in no special order.
  std::vector<SilhouetteEdge> getEdges() const;

private:
  /// An edge, its vertices sorted, and how often more it is run through upwards than downwards.
  struct Slot
  {
    std::uint64_t vertices; ///< lower one in the upper half; 0, which no edge has, in an empty slot
    std::int64_t runs;
  };

  std::size_t home(std::uint64_t vertices) const
  {
    return static_cast<std::size_t>((vertices * std::uint64_t{0x9e3779b97f4a7c15}) >> this->shift);
  }
  void erase(std::size_t hole);
  void grow();

  std::vector<Slot> slots; ///< a power of two, at most half of them in use
  unsigned shift;
  std::size_t used = 0;
};

} // namespace shadow
