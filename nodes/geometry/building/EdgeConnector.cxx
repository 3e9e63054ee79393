#include "EdgeConnector.h"

#include <algorithm>

namespace shadow
{

EdgeConnector::EdgeConnector(std::size_t vertices, std::size_t triangles)
{
  // Euler's formula gives the edges of any surface but for its components and handles; a few more make room
  // for those, and three a triangle is the most there can be.
  const std::size_t edges = std::min(vertices + triangles + triangles / 64 + 64, 3 * triangles);
  this->mesh.reserve(vertices, edges, triangles);
  for (std::size_t vertex = 0; vertex < vertices; ++vertex)
  {
    this->mesh.new_vertex();
  }
}

std::uint32_t EdgeConnector::addVertex()
{
  return static_cast<std::uint32_t>(this->mesh.new_vertex().idx());
}

OpenMesh::HalfedgeHandle EdgeConnector::findHalfedge(OpenMesh::VertexHandle from,
                                                     OpenMesh::VertexHandle to) const
{
  const OpenMesh::HalfedgeHandle first = this->mesh.halfedge_handle(from);
  OpenMesh::HalfedgeHandle halfedge = first;
  if (first.is_valid())
  {
    do
    {
      if (this->mesh.to_vertex_handle(halfedge) == to)
      {
        return halfedge;
      }
      halfedge = this->mesh.next_halfedge_handle(this->mesh.opposite_halfedge_handle(halfedge));
    } while (halfedge != first);
  }
  return OpenMesh::HalfedgeHandle();
}

bool EdgeConnector::canRelink(OpenMesh::HalfedgeHandle incoming, OpenMesh::HalfedgeHandle outgoing) const
{
  if (!incoming.is_valid() || !outgoing.is_valid() || this->mesh.next_halfedge_handle(incoming) == outgoing)
  {
    return true;
  }
  // The triangle fills the gap between two fans of triangles around a vertex. Should they be the two ends of
  // one fan, it would close this fan although further fans meet at the vertex.
  OpenMesh::HalfedgeHandle end = this->mesh.opposite_halfedge_handle(outgoing);
  do
  {
    end = this->mesh.opposite_halfedge_handle(this->mesh.next_halfedge_handle(end));
  } while (!this->mesh.is_boundary(end));
  return end != incoming;
}

bool EdgeConnector::add(const std::array<std::uint32_t, 3>& triangle)
{
  std::array<OpenMesh::VertexHandle, 3> vertices;
  std::array<OpenMesh::HalfedgeHandle, 3> halfedges;
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    vertices[corner] = OpenMesh::VertexHandle(static_cast<int>(triangle[corner]));
    if (!this->mesh.is_boundary(vertices[corner]))
    {
      return false;
    }
  }
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    halfedges[corner] = this->findHalfedge(vertices[corner], vertices[(corner + 1) % 3]);
    if (halfedges[corner].is_valid() && !this->mesh.is_boundary(halfedges[corner]))
    {
      return false;
    }
  }
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    if (!this->canRelink(halfedges[corner], halfedges[(corner + 1) % 3]))
    {
      return false;
    }
  }
  return this->mesh.add_face(vertices[0], vertices[1], vertices[2]).is_valid();
}

std::vector<Edge> EdgeConnector::readEdges() const
{
  std::vector<Edge> edges(this->mesh.n_edges());
  for (std::size_t index = 0; index < edges.size(); ++index)
  {
    // OpenMesh makes an edge for the triangle on its even half-edge; the odd one may be a border.
    const OpenMesh::HalfedgeHandle forward(static_cast<int>(2 * index));
    const OpenMesh::HalfedgeHandle backward(static_cast<int>(2 * index + 1));
    const int other = this->mesh.face_handle(backward).idx();
    edges[index].vertices = {static_cast<std::uint32_t>(this->mesh.to_vertex_handle(backward).idx()),
                             static_cast<std::uint32_t>(this->mesh.to_vertex_handle(forward).idx())};
    edges[index].triangles = {static_cast<std::uint32_t>(this->mesh.face_handle(forward).idx()),
                              other < 0 ? noTriangle : static_cast<std::uint32_t>(other)};
  }
  return edges;
}

} // namespace shadow
