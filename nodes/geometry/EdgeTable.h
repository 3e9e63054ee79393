#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <vector>

namespace shadow
{

/// Stands where an edge has no second triangle.
inline constexpr std::uint32_t noTriangle = std::numeric_limits<std::uint32_t>::max();

/// An edge and the triangles on its two sides.
struct Edge
{
  std::array<std::uint32_t, 2> vertices;  ///< from, to
  std::array<std::uint32_t, 2> triangles; ///< [0] runs through the edge as from -> to, [1] as to -> from;
                                          ///< [1] is noTriangle on a border
};

/// Every edge of a mesh once, in the order in which the facing bits of its triangles are looked at.
///
/// Each edge belongs to the word of FacingBits of the lower one of its triangles, and is the side of this
/// triangle: side s runs between the corners s and (s + 1) % 3 in raster order. Inner edges have both
/// triangles in one word, outer edges in two.
///
/// @par Memory  2 bytes an inner, 5 an outer, 4 a border edge, and 8 bytes a word: about 4 bytes a triangle
/// of a mesh whose triangles are sorted into patches
struct EdgeTable
{
  /// The number of a triangle in its word, plus 64 times a side of it.
  using Code = std::uint8_t;

  /// So many entries, all zero, stand after those of the last inner and the last outer edge.
  static constexpr std::size_t padding = 32;

  static std::uint32_t triangleOf(Code code) { return code & 63u; }
  static std::uint32_t sideOf(Code code) { return code >> 6; }

  /// @name  Entries [begins[word], begins[word + 1]) belong to the word
  /// @{
  std::vector<std::uint32_t> innerBegins;
  std::vector<Code> innerFirst;
  std::vector<Code> innerSecond; ///< the same edge as a side of the second triangle
  std::vector<std::uint32_t> outerBegins;
  std::vector<Code> outerFirst;
  std::vector<std::uint32_t> outerSecond; ///< triangle
  /// @}

  std::vector<std::uint32_t> borders; ///< 3 * triangle + side, rising

  std::size_t countInner() const { return this->innerBegins.empty() ? 0 : this->innerBegins.back(); }
  std::size_t countOuter() const { return this->outerBegins.empty() ? 0 : this->outerBegins.back(); }
  std::size_t countEdges() const { return this->countInner() + this->countOuter() + this->borders.size(); }

  /// Bytes held by the arrays.
  std::size_t getMemorySize() const;
};

/// @param edges      every edge once
/// @param triangles  corners in raster order
/// @par Cost  O(edges)
EdgeTable makeEdgeTable(const std::vector<Edge>& edges,
                        const std::vector<std::array<std::uint32_t, 3>>& triangles);

class SEDGeometry;

/// The edges of a geometry, one by one: a range that makes each Edge as it is asked for. Lasts as long as the
/// geometry.
///
/// First the inner edges, then the outer ones, then the borders.
class EdgeList
{
public:
  class Iterator
  {
  public:
    using iterator_category = std::input_iterator_tag;
    using value_type = Edge;
    using difference_type = std::ptrdiff_t;
    using pointer = const Edge*;
    using reference = Edge;

    Edge operator*() const;
    Iterator& operator++();
    bool operator==(const Iterator& other) const { return this->index == other.index; }
    bool operator!=(const Iterator& other) const { return !(*this == other); }

  private:
    friend class EdgeList;
    Iterator(const SEDGeometry& theGeometry, std::size_t theIndex) : geometry(&theGeometry), index(theIndex)
    {
    }
    void findWord();

    const SEDGeometry* geometry;
    std::size_t index;
    std::size_t word = 0; ///< the edge belongs to it, unless it is a border
  };

  explicit EdgeList(const SEDGeometry& theGeometry) : geometry(theGeometry) {}

  std::size_t size() const;
  Iterator begin() const;
  Iterator end() const { return Iterator(this->geometry, this->size()); }

  /// @pre       index < size()
  /// @par Cost  O(log(triangles)); walking is O(1) an edge
  Edge operator[](std::size_t index) const;

  /// All edges in an array, for looking them up in any order. Cost: O(edges).
  std::vector<Edge> toVector() const;

private:
  Edge makeEdge(std::size_t index, std::size_t word) const;

  const SEDGeometry& geometry;
};

} // namespace shadow
