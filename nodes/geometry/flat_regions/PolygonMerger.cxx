#include "PolygonMerger.h"

#include <numeric>
#include <utility>

namespace shadow
{

PolygonMerger::PolygonMerger(const std::vector<Edge>& meshEdges, const TriangleSides& sides,
                             std::size_t vertices)
    : edges(meshEdges), valences(sides.size(), 3), mergedInto(sides.size())
{
  std::iota(this->mergedInto.begin(), this->mergedInto.end(), 0);
  this->mesh.reserve(vertices, meshEdges.size(), sides.size());
  for (std::size_t vertex = 0; vertex < vertices; ++vertex)
  {
    this->mesh.new_vertex();
  }
  // The adjacency is known: handed over as it is, it need not be found a second time, triangle by triangle.
  for (const Edge& edge : meshEdges)
  {
    this->mesh.new_edge(OpenMesh::VertexHandle(static_cast<int>(edge.vertices[0])),
                        OpenMesh::VertexHandle(static_cast<int>(edge.vertices[1])));
  }
  for (std::size_t triangle = 0; triangle < sides.size(); ++triangle)
  {
    const OpenMesh::FaceHandle face = this->mesh.new_face();
    this->mesh.set_halfedge_handle(face, OpenMesh::HalfedgeHandle(static_cast<int>(sides[triangle][0])));
    for (std::size_t side = 0; side < 3; ++side)
    {
      const OpenMesh::HalfedgeHandle halfedge(static_cast<int>(sides[triangle][side]));
      this->mesh.set_face_handle(halfedge, face);
      this->mesh.set_next_halfedge_handle(
          halfedge, OpenMesh::HalfedgeHandle(static_cast<int>(sides[triangle][(side + 1) % 3])));
    }
  }
}

void PolygonMerger::merge(std::uint32_t edge)
{
  OpenMesh::HalfedgeHandle kept(static_cast<int>(2 * edge));
  OpenMesh::HalfedgeHandle lost(static_cast<int>(2 * edge + 1));
  if (this->mesh.face_handle(kept) == this->mesh.face_handle(lost))
  {
    return;
  }
  if (this->valences[this->mesh.face_handle(kept).idx()] < this->valences[this->mesh.face_handle(lost).idx()])
  {
    std::swap(kept, lost);
  }
  const OpenMesh::FaceHandle polygon = this->mesh.face_handle(kept);
  const OpenMesh::FaceHandle smaller = this->mesh.face_handle(lost);
  OpenMesh::HalfedgeHandle halfedge = lost;
  do
  {
    this->mesh.set_face_handle(halfedge, polygon);
    halfedge = this->mesh.next_halfedge_handle(halfedge);
  } while (halfedge != lost);

  const OpenMesh::HalfedgeHandle next = this->mesh.next_halfedge_handle(kept);
  this->mesh.set_next_halfedge_handle(this->mesh.prev_halfedge_handle(kept),
                                      this->mesh.next_halfedge_handle(lost));
  this->mesh.set_next_halfedge_handle(this->mesh.prev_halfedge_handle(lost), next);
  this->mesh.set_halfedge_handle(polygon, next);
  this->valences[polygon.idx()] += this->valences[smaller.idx()] - 2;
  this->mergedInto[smaller.idx()] = polygon.idx();
}

OpenMesh::FaceHandle PolygonMerger::findPolygon(std::uint32_t triangle) const
{
  auto face = static_cast<int>(triangle);
  while (this->mergedInto[face] != face)
  {
    face = this->mergedInto[face];
  }
  return OpenMesh::FaceHandle(face);
}

std::vector<std::array<std::uint32_t, 2>> PolygonMerger::readBorder(std::uint32_t triangle) const
{
  const OpenMesh::FaceHandle polygon = this->findPolygon(triangle);
  const OpenMesh::HalfedgeHandle first = this->mesh.halfedge_handle(polygon);
  std::vector<std::array<std::uint32_t, 2>> border;
  OpenMesh::HalfedgeHandle halfedge = first;
  do
  {
    if (this->mesh.face_handle(this->mesh.opposite_halfedge_handle(halfedge)) != polygon)
    {
      border.push_back(getSideVertices(this->edges, static_cast<std::uint32_t>(halfedge.idx())));
    }
    halfedge = this->mesh.next_halfedge_handle(halfedge);
  } while (halfedge != first);
  return border;
}

} // namespace shadow
