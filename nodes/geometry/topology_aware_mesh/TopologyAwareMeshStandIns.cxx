// Which face stands in for a face without area.
#include "TopologyAwareMesh.h"

#include <algorithm>
#include <queue>

namespace shadow
{

namespace
{

/// An edge of a face, the longest one first where they are queued.
struct Way
{
  double length; ///< model space, squared
  std::uint32_t face;
  std::uint32_t edge;

  bool operator<(const Way& other) const
  {
    return this->length != other.length ? this->length < other.length
                                        : 3 * this->face + this->edge > 3 * other.face + other.edge;
  }
};

using Ways = std::priority_queue<Way>;

void addWays(const SEDGeometry& geometry, std::uint32_t face, Ways& ways)
{
  for (std::uint32_t edge = 0; edge < 3; ++edge)
  {
    ways.push({geometry.getSquaredLength(face, edge), face, edge});
  }
}

} // namespace

/// Goes from a face without area over others, always across the longest edge that leads on, to one with a
/// side. The longest edge of a face without area covers both others: what lies across it is what an eye sees
/// beyond them. Only where two such faces have theirs in common the way leads on across another one.
class TopologyAwareMesh::StandInSearch
{
public:
  StandInSearch(const TopologyAwareMesh& theMesh, const SEDGeometry& theGeometry)
      : mesh(theMesh), geometry(theGeometry), searches(theMesh.countFaces(), 0)
  {
  }

  /// @return the face with a side, or noTriangle where the longest edge of all is a border or the way comes
  /// to a face from which there was none
  std::uint32_t find(std::uint32_t start)
  {
    ++this->search;
    this->members.clear();
    this->ways = {};
    std::uint32_t face = start;
    do
    {
      this->searches[face] = this->search;
      this->members.push_back(face);
      addWays(this->geometry, face, this->ways);
      face = this->leave();
    } while (face != noTriangle && !this->mesh.hasSide(face) && !this->hasBeenAt(face));
    return face != noTriangle && this->mesh.hasSide(face) ? face : noTriangle;
  }

  bool hasBeenAt(std::uint32_t face) const { return this->searches[face] != 0; }

  /// The faces that the last way led over.
  const std::vector<std::uint32_t>& getMembers() const { return this->members; }

private:
  /// The face across the longest edge that leads to another one than members.
  std::uint32_t leave()
  {
    bool closed = false;
    for (; !this->ways.empty(); this->ways.pop())
    {
      const Way& way = this->ways.top();
      const std::uint32_t face = this->mesh.neighbours[way.face][way.edge];
      if (face == noTriangle ? !closed : this->searches[face] != this->search)
      {
        return face;
      }
      closed = true;
    }
    return noTriangle;
  }

  const TopologyAwareMesh& mesh;
  const SEDGeometry& geometry;
  std::vector<std::uint32_t> searches; ///< which one has been at a face last; 0: none
  std::uint32_t search = 0;
  std::vector<std::uint32_t> members;
  Ways ways;
};

void TopologyAwareMesh::findStandIns(const SEDGeometry& geometry)
{
  if (geometry.getReport().zeroAreaTriangles == 0)
  {
    return;
  }
  StandInSearch search(*this, geometry);
  constexpr std::uint32_t itself = noTriangle;
  std::vector<std::uint32_t> sources(this->countFaces(), itself);
  for (std::uint32_t start = 0; start < this->countFaces(); ++start)
  {
    if (this->hasSide(start) || search.hasBeenAt(start))
    {
      continue;
    }
    const std::uint32_t last = search.find(start);
    if (last == noTriangle)
    {
      this->allHaveSides = false;
      continue;
    }
    for (const std::uint32_t member : search.getMembers())
    {
      this->normals[member] = this->normals[last];
      sources[member] = sources[last] != itself ? sources[last] : last;
    }
  }
  for (std::uint32_t face = 0; face < this->countFaces(); ++face)
  {
    if (sources[face] != itself)
    {
      this->standIns.push_back({face, sources[face]});
    }
  }
}

std::uint32_t TopologyAwareMesh::getSource(std::size_t face) const
{
  const auto standIn = std::lower_bound(this->standIns.begin(), this->standIns.end(), face,
                                        [](const StandIn& a, std::size_t b) { return a.face < b; });
  if (standIn != this->standIns.end() && standIn->face == face)
  {
    return standIn->source;
  }
  return this->hasSide(face) ? static_cast<std::uint32_t>(face) : noTriangle;
}

} // namespace shadow
