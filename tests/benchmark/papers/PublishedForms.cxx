#include "PublishedForms.h"

#include <algorithm>
#include <utility>

namespace shadow::benchmarks
{

namespace
{

std::array<std::uint32_t, 3> getOrientedTriangle(const SEDGeometry& geometry, std::size_t triangle)
{
  std::array<std::uint32_t, 3> corners = geometry.getTriangles()[triangle];
  if (geometry.getReversed().test(triangle))
  {
    std::swap(corners[1], corners[2]);
  }
  return corners;
}

PolygonFace makeTriangleFace(const SEDGeometry& geometry, std::size_t triangle)
{
  const std::array<std::uint32_t, 3> corners = getOrientedTriangle(geometry, triangle);
  const auto [a, b, c] = corners;
  return {corners, {{a, b}, {b, c}, {c, a}}};
}

/// Every edge once, from the sides of the faces.
void collectEdges(PolygonMesh& mesh)
{
  for (const PolygonFace& face : mesh.faces)
  {
    for (const auto& [from, to] : face.sides)
    {
      mesh.edges.push_back({std::min(from, to), std::max(from, to)});
    }
  }
  std::sort(mesh.edges.begin(), mesh.edges.end());
  mesh.edges.erase(std::unique(mesh.edges.begin(), mesh.edges.end()), mesh.edges.end());
}

/// Does the light see the front of a face? Evaluated from the vertices each time, as the paper counts it.
bool isVisible(const PolygonMesh& mesh, const PolygonFace& face, const glm::dvec4& lightMC,
               Operations& operations)
{
  const glm::dvec3 a = mesh.positions[face.corners[0]];
  const glm::dvec3 b = mesh.positions[face.corners[1]];
  const glm::dvec3 c = mesh.positions[face.corners[2]];
  operations.reads += 9 + 4;
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  operations.additions += 6 + 3;
  operations.multiplications += 6;
  const glm::dvec3 ray = glm::dvec3(lightMC) - lightMC.w * a;
  operations.additions += 3;
  operations.multiplications += 3;
  const double value = glm::dot(normal, ray);
  operations.additions += 2;
  operations.multiplications += 3;
  operations.comparisons += 1;
  return value > 0.0;
}

/// The list S of the triangular algorithm.
class EdgeList
{
public:
  explicit EdgeList(Operations& theOperations) : operations(theOperations) {}

  void cancelOrInsert(const DirectedEdge& side)
  {
    const DirectedEdge opposite = {side[1], side[0]};
    for (DirectedEdge& edge : this->edges)
    {
      this->operations.reads += 1;
      this->operations.comparisons += 1;
      if (edge == opposite)
      {
        edge = this->edges.back();
        this->edges.pop_back();
        this->operations.reads += 1;
        this->operations.writes += 1;
        return;
      }
    }
    this->edges.push_back(side);
    this->operations.writes += 1;
  }

  std::vector<DirectedEdge> take() { return std::move(this->edges); }

private:
  Operations& operations;
  std::vector<DirectedEdge> edges;
};

} // namespace

Operations& Operations::operator+=(const Operations& other)
{
  this->additions += other.additions;
  this->multiplications += other.multiplications;
  this->comparisons += other.comparisons;
  this->reads += other.reads;
  this->writes += other.writes;
  return *this;
}

Operations Operations::operator/(double divisor) const
{
  return {this->additions / divisor, this->multiplications / divisor, this->comparisons / divisor,
          this->reads / divisor, this->writes / divisor};
}

double PolygonMesh::getMeanSides() const
{
  std::size_t sides = 0;
  for (const PolygonFace& face : this->faces)
  {
    sides += face.sides.size();
  }
  return static_cast<double>(sides) / static_cast<double>(this->faces.size());
}

PolygonMesh makeTriangleMesh(const SEDGeometry& geometry)
{
  PolygonMesh mesh;
  mesh.positions = geometry.getPositions();
  for (std::size_t triangle = 0; triangle < geometry.getTriangles().size(); ++triangle)
  {
    mesh.faces.push_back(makeTriangleFace(geometry, triangle));
  }
  collectEdges(mesh);
  return mesh;
}

PolygonMesh makeMergedMesh(const SEDGeometry& geometry, const FlatRegions& regions)
{
  PolygonMesh mesh;
  mesh.positions = geometry.getPositions();
  for (const FlatPolygon& polygon : regions.polygons)
  {
    PolygonFace face;
    face.corners = getOrientedTriangle(geometry, polygon.representative);
    face.sides.assign(regions.border.begin() + polygon.borderBegin,
                      regions.border.begin() + polygon.borderEnd);
    mesh.faces.push_back(std::move(face));
  }
  for (std::size_t triangle = 0; triangle < geometry.getTriangles().size(); ++triangle)
  {
    if (regions.alone.test(triangle))
    {
      mesh.faces.push_back(makeTriangleFace(geometry, triangle));
    }
  }
  collectEdges(mesh);
  return mesh;
}

std::vector<DirectedEdge> findByTriangular(const PolygonMesh& mesh, const glm::dvec4& lightMC,
                                           Operations& operations)
{
  EdgeList list(operations);
  for (const PolygonFace& face : mesh.faces)
  {
    if (isVisible(mesh, face, lightMC, operations))
    {
      for (const DirectedEdge& side : face.sides)
      {
        operations.reads += 1;
        list.cancelOrInsert(side);
      }
    }
  }
  return list.take();
}

std::vector<DirectedEdge> findByVisibleNonVisible(const PolygonMesh& mesh, const glm::dvec4& lightMC,
                                                  Operations& operations)
{
  std::vector<DirectedEdge> silhouette;
  for (const DirectedEdge& edge : mesh.edges)
  {
    operations.reads += 1;
    int visible = 0;
    DirectedEdge run = edge;
    for (const PolygonFace& face : mesh.faces)
    {
      if (!isVisible(mesh, face, lightMC, operations))
      {
        continue;
      }
      for (const DirectedEdge& side : face.sides)
      {
        operations.reads += 1;
        operations.comparisons += 1;
        if (side == edge || side == DirectedEdge{edge[1], edge[0]})
        {
          ++visible;
          operations.additions += 1;
          run = side;
          break;
        }
      }
    }
    operations.comparisons += 1;
    if (visible == 1)
    {
      silhouette.push_back(run);
      operations.writes += 1;
    }
  }
  return silhouette;
}

} // namespace shadow::benchmarks
