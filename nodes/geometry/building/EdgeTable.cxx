#include "EdgeTable.h"

#include <algorithm>

#include "SEDGeometry.h"

namespace shadow
{

namespace
{

/// Which side of the triangle joins the vertices?
std::uint32_t findSide(const std::array<std::uint32_t, 3>& corners,
                       const std::array<std::uint32_t, 2>& vertices)
{
  const auto isEnd = [&vertices](std::uint32_t corner)
  { return corner == vertices[0] || corner == vertices[1]; };
  return !isEnd(corners[2]) ? 0 : !isEnd(corners[0]) ? 1 : 2;
}

EdgeTable::Code makeCode(std::uint32_t triangle, std::uint32_t side)
{
  return static_cast<EdgeTable::Code>(side << 6 | (triangle & 63u));
}

/// An edge as a side of the lower one of its triangles; the other one may be noTriangle.
struct OrderedEdge
{
  std::uint32_t first;
  std::uint32_t side;
  std::uint32_t second;

  OrderedEdge(const Edge& edge, const std::vector<std::array<std::uint32_t, 3>>& triangles)
      : first(std::min(edge.triangles[0], edge.triangles[1])),
        side(findSide(triangles[first], edge.vertices)),
        second(std::max(edge.triangles[0], edge.triangles[1]))
  {
  }

  bool isBorder() const { return this->second == noTriangle; }
  bool isInner() const { return this->first >> 6 == this->second >> 6; }
};

/// Counts the edges of each word, and lays out their records.
void layOut(const std::vector<Edge>& edges, const std::vector<std::array<std::uint32_t, 3>>& triangles,
            EdgeTable& table)
{
  constexpr std::size_t readBeyond = 32;
  table.words.assign((triangles.size() + 63) / 64, {});
  std::size_t borders = 0;
  for (const Edge& edge : edges)
  {
    const OrderedEdge ordered(edge, triangles);
    EdgeTable::Word& word = table.words[ordered.first >> 6];
    borders += ordered.isBorder() ? 1 : 0;
    if (!ordered.isBorder())
    {
      ++(ordered.isInner() ? word.inner : word.outer);
    }
  }
  std::uint32_t place = 0;
  for (EdgeTable::Word& word : table.words)
  {
    word.place = place;
    place += word.outer + (word.outer + 2u * word.inner + 3u) / 4u;
    table.innerEdges += word.inner;
    table.outerEdges += word.outer;
  }
  table.data.assign(place + readBeyond / 4, 0);
  table.borders.reserve(borders);
}

} // namespace

std::size_t EdgeTable::getMemorySize() const
{
  return sizeof(Word) * this->words.capacity() + 4 * (this->data.capacity() + this->borders.capacity());
}

EdgeTable makeEdgeTable(const std::vector<Edge>& edges,
                        const std::vector<std::array<std::uint32_t, 3>>& triangles)
{
  EdgeTable table;
  layOut(edges, triangles, table);
  // How many edges of each word are in their place.
  struct Filled
  {
    std::uint8_t inner = 0;
    std::uint8_t outer = 0;
  };
  std::vector<Filled> filled(table.words.size());
  for (const Edge& edge : edges)
  {
    const OrderedEdge ordered(edge, triangles);
    if (ordered.isBorder())
    {
      table.borders.push_back(3 * ordered.first + ordered.side);
      continue;
    }
    const EdgeTable::Word& word = table.words[ordered.first >> 6];
    Filled& next = filled[ordered.first >> 6];
    std::uint32_t* outerSecond = table.data.data() + word.place;
    auto* codes = reinterpret_cast<EdgeTable::Code*>(outerSecond + word.outer);
    if (ordered.isInner())
    {
      codes[word.outer + next.inner] = makeCode(ordered.first, ordered.side);
      codes[word.outer + word.inner + next.inner] =
          makeCode(ordered.second, findSide(triangles[ordered.second], edge.vertices));
      ++next.inner;
    }
    else
    {
      codes[next.outer] = makeCode(ordered.first, ordered.side);
      outerSecond[next.outer] = ordered.second;
      ++next.outer;
    }
  }
  // Sides go by where corners lie, vertices do not: so the order stays when a mesh moves.
  std::sort(table.borders.begin(), table.borders.end(),
            [&triangles](std::uint32_t a, std::uint32_t b)
            {
              const auto opposite = [&triangles](std::uint32_t border)
              { return triangles[border / 3][(border % 3 + 2) % 3]; };
              return a / 3 != b / 3 ? a < b : opposite(a) < opposite(b);
            });
  return table;
}

std::size_t EdgeList::size() const
{
  return this->geometry.getEdgeTable().countEdges();
}

EdgeList::Iterator EdgeList::begin() const
{
  Iterator first(this->geometry, 0);
  first.findWord();
  return first;
}

std::vector<Edge> EdgeList::toVector() const
{
  std::vector<Edge> edges;
  edges.reserve(this->size());
  for (const Edge& edge : *this)
  {
    edges.push_back(edge);
  }
  return edges;
}

Edge EdgeList::Iterator::operator*() const
{
  const EdgeTable& table = this->geometry->getEdgeTable();
  if (this->word == table.words.size())
  {
    const std::uint32_t border = table.borders[this->inWord];
    return {this->geometry->getSide(border / 3, border % 3), {border / 3, noTriangle}};
  }
  const EdgeTable::Record record = table.getRecord(this->word);
  const auto base = static_cast<std::uint32_t>(64 * this->word);
  const bool inner = this->inWord < record.inner;
  const std::size_t outer = this->inWord - record.inner;
  const EdgeTable::Code code = inner ? record.innerFirst[this->inWord] : record.outerFirst[outer];
  const std::uint32_t first = base + EdgeTable::triangleOf(code);
  const std::uint32_t second =
      inner ? base + EdgeTable::triangleOf(record.innerSecond[this->inWord]) : record.outerSecond[outer];
  return {this->geometry->getSide(first, EdgeTable::sideOf(code)), {first, second}};
}

EdgeList::Iterator& EdgeList::Iterator::operator++()
{
  ++this->index;
  ++this->inWord;
  this->findWord();
  return *this;
}

/// Walks on to the word that the edge belongs to.
void EdgeList::Iterator::findWord()
{
  const std::vector<EdgeTable::Word>& words = this->geometry->getEdgeTable().words;
  while (this->word < words.size() &&
         this->inWord == std::size_t{words[this->word].inner} + words[this->word].outer)
  {
    ++this->word;
    this->inWord = 0;
  }
}

} // namespace shadow
