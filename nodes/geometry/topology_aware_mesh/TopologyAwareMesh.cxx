#include "TopologyAwareMesh.h"

#include <algorithm>
#include <vector>

#include "ExactOrientation.h"

namespace shadow
{

namespace
{

bool hasArea(const SEDGeometry& geometry, std::size_t face)
{
  return geometry.getPlane(face).normal != glm::dvec3(0.0);
}

} // namespace

TopologyAwareMesh::TopologyAwareMesh(const SEDGeometry& geometry)
{
  const std::size_t faces = geometry.getTriangles().size();
  this->copies = geometry.getCopies();
  this->neighbours.assign(faces, {noTriangle, noTriangle, noTriangle});
  this->normals.resize(faces);
  for (std::size_t face = 0; face < faces; ++face)
  {
    const glm::dvec3 normal = geometry.getPlane(face).normal;
    const double length = glm::length(normal);
    this->normals[face] = length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0f);
  }
  this->linkNeighbours(geometry);
  this->pairBorders(geometry);
  this->findStandIns(geometry);
}

void TopologyAwareMesh::linkNeighbours(const SEDGeometry& geometry)
{
  forEachEdge(geometry.getEdgeTable(),
              [&](std::uint32_t first, std::uint32_t side, std::uint32_t second)
              {
                if (second == noTriangle)
                {
                  return;
                }
                this->neighbours[first][side] = second;
                const std::array<std::uint32_t, 2> ends = geometry.getSide(first, side);
                for (const std::uint32_t other : {0u, 1u, 2u})
                {
                  const std::array<std::uint32_t, 2> otherEnds = geometry.getSide(second, other);
                  if (std::is_permutation(ends.begin(), ends.end(), otherEnds.begin()))
                  {
                    this->neighbours[second][other] = first;
                  }
                }
              });
}

// Borders at the same place, two of them, along which their faces run the same way.
void TopologyAwareMesh::pairBorders(const SEDGeometry& geometry)
{
  struct Place
  {
    std::array<float, 6> ends; ///< positions, the lesser one first
    bool forwards;             ///< the oriented face runs from there
    std::uint32_t side;
  };
  std::vector<Place> places;
  for (const std::uint32_t side : geometry.getEdgeTable().borders)
  {
    if (this->copies.test(side / 3))
    {
      continue;
    }
    const std::array<std::uint32_t, 2> vertices = geometry.getSide(side / 3, side % 3);
    const glm::vec3& from = geometry.getPositions()[vertices[0]];
    const glm::vec3& to = geometry.getPositions()[vertices[1]];
    const std::array<float, 6> there = {from.x, from.y, from.z, to.x, to.y, to.z};
    const std::array<float, 6> back = {to.x, to.y, to.z, from.x, from.y, from.z};
    places.push_back({std::min(there, back), there < back, side});
  }
  std::sort(places.begin(), places.end(),
            [](const Place& a, const Place& b)
            { return a.ends != b.ends ? a.ends < b.ends : a.side < b.side; });
  for (std::size_t first = 0; first < places.size();)
  {
    std::size_t end = first + 1;
    while (end < places.size() && places[end].ends == places[first].ends)
    {
      ++end;
    }
    if (end - first == 2 && places[first].forwards == places[first + 1].forwards)
    {
      this->turnedPairs.push_back({places[first].side, places[first + 1].side});
      this->turnedPairs.push_back({places[first + 1].side, places[first].side});
    }
    else
    {
      for (; first < end; ++first)
      {
        this->borders.push_back(places[first].side);
      }
    }
    first = end;
  }
  std::sort(this->borders.begin(), this->borders.end());
  std::sort(this->turnedPairs.begin(), this->turnedPairs.end(),
            [](const TurnedPair& a, const TurnedPair& b) { return a.side < b.side; });
}

std::uint32_t TopologyAwareMesh::getTurnedNeighbour(std::size_t face, std::size_t edge) const
{
  const auto side = static_cast<std::uint32_t>(3 * face + edge);
  const auto pair = std::lower_bound(this->turnedPairs.begin(), this->turnedPairs.end(), side,
                                     [](const TurnedPair& a, std::uint32_t b) { return a.side < b; });
  return pair != this->turnedPairs.end() && pair->side == side ? pair->other / 3 : noTriangle;
}

glm::vec3 TopologyAwareMesh::getNeighbourNormal(std::size_t face, std::size_t edge) const
{
  const std::uint32_t neighbour = this->neighbours[face][edge];
  if (neighbour != noTriangle)
  {
    return this->normals[neighbour];
  }
  if (this->copies.test(face))
  {
    return this->normals[face];
  }
  const std::uint32_t turned = this->getTurnedNeighbour(face, edge);
  return -this->normals[turned != noTriangle ? turned : face];
}

EdgeFate TopologyAwareMesh::getFate(const SEDGeometry& geometry, std::size_t face, std::size_t edge) const
{
  if (this->copies.test(face))
  {
    return EdgeFate::Never;
  }
  const std::uint32_t neighbour = this->neighbours[face][edge];
  const std::uint32_t turned = neighbour == noTriangle ? this->getTurnedNeighbour(face, edge) : noTriangle;
  if (neighbour == noTriangle && turned == noTriangle)
  {
    return EdgeFate::Border;
  }
  const std::uint32_t other = this->getSource(turned != noTriangle ? turned : neighbour);
  if (!hasArea(geometry, face) || other == noTriangle)
  {
    return EdgeFate::Never;
  }
  return turned == noTriangle && this->lieAlike(geometry, static_cast<std::uint32_t>(face), other)
             ? EdgeFate::Never
             : EdgeFate::Open;
}

bool TopologyAwareMesh::lieAlike(const SEDGeometry& geometry, std::uint32_t face, std::uint32_t other)
{
  if (face == other)
  {
    return true;
  }
  const glm::dvec3 normal = geometry.getPlane(face).normal;
  const glm::dvec3 otherNormal = geometry.getPlane(other).normal;
  const double cosine = glm::dot(normal, otherNormal) / (glm::length(normal) * glm::length(otherNormal));
  // Spares most pairs the exact test.
  if (!(cosine > 0.999999))
  {
    return false;
  }
  const std::vector<glm::vec3>& positions = geometry.getPositions();
  const std::array<std::uint32_t, 3>& corners = geometry.getTriangles()[face];
  const std::array<std::uint32_t, 3>& others = geometry.getTriangles()[other];
  return std::all_of(others.begin(), others.end(),
                     [&](std::uint32_t vertex)
                     {
                       return std::find(corners.begin(), corners.end(), vertex) != corners.end() ||
                              exactOrientation(positions[corners[0]], positions[corners[1]],
                                               positions[corners[2]],
                                               glm::dvec4(positions[vertex], 1.0)) == 0;
                     });
}

std::size_t TopologyAwareMesh::getMemorySize() const
{
  return this->neighbours.capacity() * sizeof(this->neighbours[0]) +
         this->copies.getWords().capacity() * sizeof(std::uint64_t) +
         this->normals.capacity() * sizeof(this->normals[0]) +
         this->borders.capacity() * sizeof(this->borders[0]) +
         this->turnedPairs.capacity() * sizeof(this->turnedPairs[0]) +
         this->standIns.capacity() * sizeof(this->standIns[0]);
}

} // namespace shadow
