#include "EdgeTable.h"

#include <algorithm>
#include <utility>

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

/// Turns counts into begins: entry i becomes the sum of the entries before it.
void sumUp(std::vector<std::uint32_t>& counts)
{
  std::uint32_t sum = 0;
  for (std::uint32_t& count : counts)
  {
    sum += std::exchange(count, sum);
  }
}

/// After filling, each begin stands where its successor stood.
void shiftBack(std::vector<std::uint32_t>& begins)
{
  std::copy_backward(begins.begin(), begins.end() - 1, begins.end());
  begins.front() = 0;
}

EdgeTable::Code makeCode(std::uint32_t triangle, std::uint32_t side)
{
  return static_cast<EdgeTable::Code>(side << 6 | (triangle & 63u));
}

} // namespace

std::size_t EdgeTable::getMemorySize() const
{
  return 4 * (this->innerBegins.capacity() + this->outerBegins.capacity() + this->outerSecond.capacity() +
              this->borders.capacity()) +
         this->innerFirst.capacity() + this->innerSecond.capacity() + this->outerFirst.capacity();
}

EdgeTable makeEdgeTable(const std::vector<Edge>& edges,
                        const std::vector<std::array<std::uint32_t, 3>>& triangles)
{
  const std::size_t words = (triangles.size() + 63) / 64;
  EdgeTable table;
  table.innerBegins.assign(words + 1, 0);
  table.outerBegins.assign(words + 1, 0);
  std::size_t borders = 0;
  for (const Edge& edge : edges)
  {
    const std::uint32_t first = std::min(edge.triangles[0], edge.triangles[1]);
    const std::uint32_t second = std::max(edge.triangles[0], edge.triangles[1]);
    borders += second == noTriangle ? 1 : 0;
    if (second != noTriangle)
    {
      ++(first >> 6 == second >> 6 ? table.innerBegins : table.outerBegins)[first >> 6];
    }
  }
  sumUp(table.innerBegins);
  sumUp(table.outerBegins);
  table.innerFirst.assign(table.innerBegins.back() + EdgeTable::padding, 0);
  table.innerSecond.assign(table.innerBegins.back() + EdgeTable::padding, 0);
  table.outerFirst.assign(table.outerBegins.back() + EdgeTable::padding, 0);
  table.outerSecond.assign(table.outerBegins.back() + EdgeTable::padding, 0);
  table.borders.reserve(borders);

  for (const Edge& edge : edges)
  {
    const std::uint32_t first = std::min(edge.triangles[0], edge.triangles[1]);
    const std::uint32_t second = std::max(edge.triangles[0], edge.triangles[1]);
    const std::uint32_t side = findSide(triangles[first], edge.vertices);
    if (second == noTriangle)
    {
      table.borders.push_back(3 * first + side);
    }
    else if (first >> 6 == second >> 6)
    {
      const std::uint32_t place = table.innerBegins[first >> 6]++;
      table.innerFirst[place] = makeCode(first, side);
      table.innerSecond[place] = makeCode(second, findSide(triangles[second], edge.vertices));
    }
    else
    {
      const std::uint32_t place = table.outerBegins[first >> 6]++;
      table.outerFirst[place] = makeCode(first, side);
      table.outerSecond[place] = second;
    }
  }
  shiftBack(table.innerBegins);
  shiftBack(table.outerBegins);
  std::sort(table.borders.begin(), table.borders.end());
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

Edge EdgeList::operator[](std::size_t index) const
{
  const EdgeTable& table = this->geometry.getEdgeTable();
  const bool inner = index < table.countInner();
  const std::vector<std::uint32_t>& begins = inner ? table.innerBegins : table.outerBegins;
  const std::size_t place = inner ? index : index - table.countInner();
  const auto after = std::upper_bound(begins.begin(), begins.end(), place);
  return this->makeEdge(index, static_cast<std::size_t>(after - begins.begin()) - 1);
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

Edge EdgeList::makeEdge(std::size_t index, std::size_t word) const
{
  const EdgeTable& table = this->geometry.getEdgeTable();
  const auto base = static_cast<std::uint32_t>(64 * word);
  std::array<std::uint32_t, 2> triangles{};
  std::uint32_t side = 0;
  if (index < table.countInner())
  {
    triangles = {base + EdgeTable::triangleOf(table.innerFirst[index]),
                 base + EdgeTable::triangleOf(table.innerSecond[index])};
    side = EdgeTable::sideOf(table.innerFirst[index]);
  }
  else if (const std::size_t outer = index - table.countInner(); outer < table.countOuter())
  {
    triangles = {base + EdgeTable::triangleOf(table.outerFirst[outer]), table.outerSecond[outer]};
    side = EdgeTable::sideOf(table.outerFirst[outer]);
  }
  else
  {
    const std::uint32_t border = table.borders[outer - table.countOuter()];
    triangles = {border / 3, noTriangle};
    side = border % 3;
  }
  return {this->geometry.getSide(triangles[0], side), triangles};
}

Edge EdgeList::Iterator::operator*() const
{
  return EdgeList(*this->geometry).makeEdge(this->index, this->word);
}

EdgeList::Iterator& EdgeList::Iterator::operator++()
{
  ++this->index;
  this->findWord();
  return *this;
}

/// Walks on to the word that the edge belongs to.
void EdgeList::Iterator::findWord()
{
  const EdgeTable& table = this->geometry->getEdgeTable();
  const std::size_t inner = table.countInner();
  const std::vector<std::uint32_t>& begins = this->index < inner ? table.innerBegins : table.outerBegins;
  const std::size_t place = this->index < inner ? this->index : this->index - inner;
  this->word = this->index == inner ? 0 : this->word;
  while (this->word + 1 < begins.size() && begins[this->word + 1] <= place)
  {
    ++this->word;
  }
}

} // namespace shadow
