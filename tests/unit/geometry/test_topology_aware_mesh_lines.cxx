// Valient's mesh: that it knows the silhouette, borders and creases.

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "SilhouetteFinder.h"
#include "SilhouetteOracle.h"
#include "TestMeshes.h"
#include "TopologyAwareMesh.h"

namespace shadow::test
{

namespace
{

using EdgeSet = std::set<std::pair<std::uint32_t, std::uint32_t>>;

std::pair<std::uint32_t, std::uint32_t> undirected(std::uint32_t a, std::uint32_t b)
{
  return std::minmax(a, b);
}

EdgeSet toSet(const SEDGeometry& geometry, const std::vector<FaceEdges>& lines)
{
  EdgeSet set;
  for (const FaceEdges& line : lines)
  {
    for (std::size_t edge = 0; edge < 3; ++edge)
    {
      if ((line.edges >> edge & 9u) != 0)
      {
        const auto& corners = geometry.getTriangles()[line.face];
        set.insert(undirected(corners[edge], corners[(edge + 1) % 3]));
      }
    }
  }
  return set;
}

/// Where a border lies, and on which side of the plane through it and the eye its face is.
using BorderPlace = std::pair<std::array<float, 6>, bool>;

BorderPlace placeOf(const SEDGeometry& geometry, const Edge& edge, const LightFacing& facing)
{
  const glm::vec3& from = geometry.getPositions()[edge.vertices[0]];
  const glm::vec3& to = geometry.getPositions()[edge.vertices[1]];
  const std::array<float, 6> there = {from.x, from.y, from.z, to.x, to.y, to.z};
  const std::array<float, 6> back = {to.x, to.y, to.z, from.x, from.y, from.z};
  return {std::min(there, back), (there < back) == facing.towards.test(edge.triangles[0])};
}

/// Borders with one other at the same place whose face runs along it the same way.
EdgeSet findTurned(const SEDGeometry& geometry, const LightFacing& facing, bool onOneSide)
{
  // All faces towards the eye: sides of borders that run alike are then alike.
  LightFacing alike;
  alike.towards.assign(geometry.getTriangles().size());
  for (std::size_t face = 0; face < alike.towards.size(); ++face)
  {
    alike.towards.set(face);
  }
  std::map<std::array<float, 6>, std::vector<Edge>> borders;
  for (const Edge& edge : geometry.getEdges())
  {
    if (edge.triangles[1] == noTriangle)
    {
      borders[placeOf(geometry, edge, alike).first].push_back(edge);
    }
  }
  EdgeSet set;
  for (const auto& entry : borders)
  {
    const std::vector<Edge>& edges = entry.second;
    if (edges.size() != 2 || placeOf(geometry, edges[0], alike) != placeOf(geometry, edges[1], alike))
    {
      continue;
    }
    if (!onOneSide || placeOf(geometry, edges[0], facing) == placeOf(geometry, edges[1], facing))
    {
      set.insert(undirected(edges[0].vertices[0], edges[0].vertices[1]));
      set.insert(undirected(edges[1].vertices[0], edges[1].vertices[1]));
    }
  }
  return set;
}

/// Edges by where they are: of two at one place either may be the one that is drawn.
std::set<std::array<float, 6>> atPlaces(const SEDGeometry& geometry, const EdgeSet& edges)
{
  std::set<std::array<float, 6>> places;
  for (const auto& [a, b] : edges)
  {
    const glm::vec3& from = geometry.getPositions()[a];
    const glm::vec3& to = geometry.getPositions()[b];
    const std::array<float, 6> there = {from.x, from.y, from.z, to.x, to.y, to.z};
    const std::array<float, 6> back = {to.x, to.y, to.z, from.x, from.y, from.z};
    places.insert(std::min(there, back));
  }
  return places;
}

/// Edges whose faces differ, and borders, by a facing that needs no completion.
EdgeSet findByDefinition(const SEDGeometry& geometry, const LightFacing& facing, bool silhouette, bool border)
{
  EdgeSet set = silhouette ? findTurned(geometry, facing, true) : EdgeSet();
  const EdgeSet turned = findTurned(geometry, facing, false);
  for (const Edge& edge : geometry.getEdges())
  {
    const bool isBorder = edge.triangles[1] == noTriangle;
    if (isBorder && turned.count(undirected(edge.vertices[0], edge.vertices[1])) != 0)
    {
      continue;
    }
    const bool differs =
        !isBorder && facing.towards.test(edge.triangles[0]) != facing.towards.test(edge.triangles[1]);
    if ((isBorder && border) || (differs && silhouette))
    {
      set.insert(undirected(edge.vertices[0], edge.vertices[1]));
    }
  }
  return set;
}

} // namespace

TEST(TopologyAwareMesh, AnyMesh_AnyEye_LinesAreTheExactSilhouetteAndTheBorders)
{
  std::mt19937 random(7);
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    if (geometry.getReport().zeroAreaTriangles > 0)
    {
      continue;
    }
    const TopologyAwareMesh tam(geometry);
    for (int round = 0; round < 10; ++round)
    {
      const glm::dvec4 eye(randomPoint(random, 4.0), round % 3 == 0 ? 0.0 : 1.0);
      const LightFacing exact = faceExactly(geometry, eye);
      for (const auto method : {SilhouetteMethod::BruteForce, SilhouetteMethod::Hierarchical})
      {
        LightFacing facing;
        makeSilhouetteFinder(method)->face(geometry, eye, facing);
        tam.completeFacing(facing);
        for (int kinds = 0; kinds < 4; ++kinds)
        {
          std::vector<FaceEdges> lines;
          const bool silhouette = kinds % 2 == 1;
          const bool border = kinds / 2 == 1;
          tam.findLines(geometry, facing, {silhouette, border}, lines);
          EXPECT_EQ(atPlaces(geometry, toSet(geometry, lines)),
                    atPlaces(geometry, findByDefinition(geometry, exact, silhouette, border)));
          EXPECT_TRUE(std::is_sorted(lines.begin(), lines.end(),
                                     [](const FaceEdges& a, const FaceEdges& b)
                                     { return a.face <= b.face; }));
        }
      }
    }
  }
}

TEST(TopologyAwareMesh, ClosedMesh_StoredNormalsTellTheSilhouette)
{
  // What a shader does with one face alone: compare the signs of its own normal and of those it stores.
  const SEDGeometry geometry = build(makeSphere(1.0, 24, 13));
  const TopologyAwareMesh tam(geometry);
  const glm::dvec4 eye(3.1, 2.3, 1.7, 1.0);
  const LightFacing exact = faceExactly(geometry, eye);
  std::vector<FaceEdges> seen;
  for (std::uint32_t face = 0; face < tam.countFaces(); ++face)
  {
    for (std::uint32_t edge = 0; edge < 3; ++edge)
    {
      const glm::vec3 corner = geometry.getPositions()[geometry.getTriangles()[face][edge]];
      const glm::vec3 toEye = glm::vec3(eye) - corner;
      const bool own = glm::dot(tam.getNormal(face), toEye) > 0.0f;
      for (const glm::vec3& stored :
           {tam.getNeighbourNormal(face, edge), unpackNormal(packNormal(tam.getNeighbourNormal(face, edge)))})
      {
        const bool other = glm::dot(stored, toEye) > 0.0f;
        if (own != other)
        {
          seen.push_back({face, 1u << edge});
        }
      }
    }
  }
  EXPECT_FALSE(seen.empty());
  EXPECT_EQ(toSet(geometry, seen), findByDefinition(geometry, exact, true, true));
}

TEST(TopologyAwareMesh, Moebius_ItsCutIsNoBorder)
{
  const SEDGeometry geometry = build(makeMoebius(16));
  const TopologyAwareMesh tam(geometry);
  std::vector<FaceEdges> lines;
  const LightFacing facing = computeFacing(geometry, {0.3, 0.4, 7.0, 1.0});
  tam.findLines(geometry, facing, {false, true}, lines);
  std::size_t edges = 0;
  for (const FaceEdges& line : lines)
  {
    edges += (line.edges & 1u) + (line.edges >> 1 & 1u) + (line.edges >> 2);
  }
  EXPECT_GT(geometry.getReport().borderEdges, 32u);
  EXPECT_EQ(edges, 32u);
}

TEST(TopologyAwareMesh, FaceWithoutArea_DrawsNoLineAcrossAPlane)
{
  // A square of two triangles below, and three above a T-junction in the middle, closed by a face without
  // area.
  TriangleSoup soup;
  soup.points = {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  soup.triangles = {{0, 1, 3}, {1, 2, 3}, {0, 4, 2}, {0, 2, 1}};
  const SEDGeometry geometry = build(soup);
  ASSERT_EQ(geometry.getReport().zeroAreaTriangles, 1u);
  const TopologyAwareMesh tam(geometry);
  for (const double z : {2.0, -2.0})
  {
    LightFacing facing = computeFacing(geometry, {0.2, 0.1, z, 1.0});
    tam.completeFacing(facing);
    std::vector<FaceEdges> lines;
    tam.findLines(geometry, facing, {true, false}, lines);
    EXPECT_TRUE(lines.empty());
  }
  EXPECT_TRUE(tam.findCreases(geometry, 1.0).empty());
}

TEST(TopologyAwareMesh, Creases_OfAFlatPart_NoneAtAnyAngle)
{
  // Exactly in a plane, with normals that single precision rounds.
  for (const glm::dvec2& slope : {glm::dvec2(1.0, 1.0), glm::dvec2(1.0, 2.0), glm::dvec2(0.5, -0.25)})
  {
    TriangleSoup soup = makeFlatSquare(8);
    for (glm::dvec3& point : soup.points)
    {
      point.z = slope.x * point.x + slope.y * point.y;
    }
    const SEDGeometry geometry = build(soup);
    const TopologyAwareMesh tam(geometry);
    for (const double degrees : {0.0, 1e-9, 1e-3})
    {
      EXPECT_TRUE(tam.findCreases(geometry, degrees).empty()) << degrees;
    }
    soup.points[3 * 9 + 3].z += 0.25;
    const SEDGeometry bent = build(soup);
    EXPECT_EQ(toSet(bent, TopologyAwareMesh(bent).findCreases(bent, 0.0)).size(), 12u) << "six and their rim";
  }
}

TEST(TopologyAwareMesh, Creases_OfACube_AreItsTwelveEdges)
{
  const SEDGeometry geometry = build(makeCube());
  const TopologyAwareMesh tam(geometry);
  EXPECT_EQ(toSet(geometry, tam.findCreases(geometry, 89.0)).size(), 12u);
  EXPECT_EQ(toSet(geometry, tam.findCreases(geometry, 91.0)).size(), 0u);
  std::vector<FaceEdges> lines;
  const std::vector<FaceEdges> creases = tam.findCreases(geometry, 30.0);
  LightFacing facing = computeFacing(geometry, {5.0, 4.0, 3.0, 1.0});
  tam.findLines(geometry, facing, {true, true, &creases}, lines);
  EXPECT_EQ(toSet(geometry, lines).size(), 12u);
}

} // namespace shadow::test
