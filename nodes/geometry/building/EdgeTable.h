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
/// @par Memory  2 bytes an inner, 5 an outer, 4 a border edge, and 10 bytes a word: about 4 bytes a triangle
/// of a mesh whose triangles are sorted into patches
struct EdgeTable
{
  /// The number of a triangle in its word, plus 64 times a side of it.
  using Code = std::uint8_t;

  static std::uint32_t triangleOf(Code code) { return code & 63u; }
  static std::uint32_t sideOf(Code code) { return code >> 6; }

  static constexpr std::size_t mostOfWord = 192; ///< each is a side of one of 64 triangles

  /// The edges of one word. So many bytes may be read from each array: those of its edges, and 32 more.
  struct Record
  {
    std::size_t inner; ///< edges; 96 at most
    std::size_t outer; ///< edges; 192 at most
    const Code* innerFirst;
    const Code* innerSecond; ///< the same edges as sides of their second triangles
    const Code* outerFirst;
    const std::uint32_t* outerSecond; ///< triangles
  };

  Record getRecord(std::size_t word) const
  {
    const Word& at = this->words[word];
    const std::uint32_t* outerSecond = this->data.data() + at.place;
    const auto* codes = reinterpret_cast<const Code*>(outerSecond + at.outer);
    return {at.inner, at.outer, codes + at.outer, codes + at.outer + at.inner, codes, outerSecond};
  }

  /// Where a record lies; see getRecord().
  struct Word
  {
    std::uint32_t place; ///< in data
    std::uint8_t inner;
    std::uint8_t outer;
  };

  std::vector<Word> words;
  std::vector<std::uint32_t> data;    ///< records one after the other, so that each is in few cache lines
  std::vector<std::uint32_t> borders; ///< 3 * triangle + side; by triangle, then by the vertex opposite
  std::size_t innerEdges = 0;
  std::size_t outerEdges = 0;

  std::size_t countEdges() const { return this->innerEdges + this->outerEdges + this->borders.size(); }

  /// Bytes held by the arrays.
  std::size_t getMemorySize() const;
};

/// Calls visit(first, side, second) for every edge in the order of EdgeList: its lower triangle, which side
/// of that it is, and the other triangle or noTriangle.
///
/// @par Cost  O(edges); less than an EdgeList, which looks up vertices
template <class Visit>
void forEachEdge(const EdgeTable& table, Visit&& visit)
{
  for (std::size_t word = 0; word < table.words.size(); ++word)
  {
    const EdgeTable::Record record = table.getRecord(word);
    const auto base = static_cast<std::uint32_t>(64 * word);
    for (std::size_t i = 0; i < record.inner; ++i)
    {
      const EdgeTable::Code code = record.innerFirst[i];
      visit(base + EdgeTable::triangleOf(code), EdgeTable::sideOf(code),
            base + EdgeTable::triangleOf(record.innerSecond[i]));
    }
    for (std::size_t i = 0; i < record.outer; ++i)
    {
      const EdgeTable::Code code = record.outerFirst[i];
      visit(base + EdgeTable::triangleOf(code), EdgeTable::sideOf(code), record.outerSecond[i]);
    }
  }
  for (const std::uint32_t border : table.borders)
  {
    visit(border / 3, border % 3, noTriangle);
  }
}

/// @param edges      every edge once
/// @param triangles  corners in raster order
/// @par Cost  O(edges)
EdgeTable makeEdgeTable(const std::vector<Edge>& edges,
                        const std::vector<std::array<std::uint32_t, 3>>& triangles);

class SEDGeometry;

/// The edges of a geometry, one by one: a range that makes each Edge as it is asked for. Lasts as long as the
/// geometry. Those of each word, inner before outer ones, then the borders.
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
    std::size_t word = 0;   ///< the edge belongs to it; behind the last one for borders
    std::size_t inWord = 0; ///< number in the word, or of the border
  };

  explicit EdgeList(const SEDGeometry& theGeometry) : geometry(theGeometry) {}

  std::size_t size() const;
  Iterator begin() const;
  Iterator end() const { return Iterator(this->geometry, this->size()); }

  /// All edges in an array, for looking them up in any order. Cost: O(edges).
  std::vector<Edge> toVector() const;

private:
  const SEDGeometry& geometry;
};

} // namespace shadow
