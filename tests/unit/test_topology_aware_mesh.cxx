// Valient's mesh: what it stores, how large it is, and that it knows the silhouette.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <random>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "MeshFiles.h"
#include "SilhouetteFinder.h"
#include "SilhouetteOracle.h"
#include "TestLights.h"
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

glm::vec3 readVector(const std::vector<unsigned char>& bytes, std::size_t place)
{
  glm::vec3 value;
  std::memcpy(&value, bytes.data() + place, sizeof(value));
  return value;
}

} // namespace

TEST(TopologyAwareMesh, AnyMesh_NeighboursAreMutual)
{
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    const TopologyAwareMesh tam(geometry);
    ASSERT_EQ(tam.countFaces(), geometry.getTriangles().size());
    std::size_t borders = 0;
    for (std::uint32_t face = 0; face < tam.countFaces(); ++face)
    {
      for (std::size_t edge = 0; edge < 3; ++edge)
      {
        const std::uint32_t neighbour = tam.getNeighbour(face, edge);
        if (neighbour == noTriangle)
        {
          ++borders;
          continue;
        }
        EXPECT_EQ(tam.getNeighbourNormal(face, edge), tam.getNormal(neighbour));
        EXPECT_TRUE(tam.getNeighbour(neighbour, 0) == face || tam.getNeighbour(neighbour, 1) == face ||
                    tam.getNeighbour(neighbour, 2) == face);
      }
    }
    EXPECT_EQ(borders, geometry.getReport().borderEdges);
  }
}

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

TEST(TopologyAwareMesh, NonManifoldEdge_PairsHaveNeighboursAndTheRestBorders)
{
  const auto countInner = [](const SEDGeometry& geometry)
  {
    const TopologyAwareMesh tam(geometry);
    std::size_t inner = 0;
    for (std::size_t face = 0; face < tam.countFaces(); ++face)
    {
      for (std::size_t edge = 0; edge < 3; ++edge)
      {
        inner += tam.getNeighbour(face, edge) != noTriangle ? 1 : 0;
      }
    }
    return inner;
  };
  // Four faces at one edge, of two solids: two pairs.
  const SEDGeometry cubes = build(makeCubesSharingAnEdge());
  EXPECT_EQ(cubes.getReport().nonManifoldEdges, 1u);
  EXPECT_EQ(countInner(cubes), 3 * cubes.getTriangles().size());
  // Pages that run through their edge the same way, of which no two are a pair.
  const SEDGeometry book = build(makeBook(3));
  EXPECT_EQ(book.getReport().nonManifoldEdges, 1u);
  EXPECT_EQ(countInner(book), 0u);
}

TEST(TopologyAwareMesh, OpenMesh_BordersHaveTheNegatedOwnNormal)
{
  const SEDGeometry geometry = build(makeOpenCylinder(12));
  const TopologyAwareMesh tam(geometry);
  std::size_t borders = 0;
  for (std::size_t face = 0; face < tam.countFaces(); ++face)
  {
    for (std::size_t edge = 0; edge < 3; ++edge)
    {
      if (tam.getNeighbour(face, edge) == noTriangle)
      {
        ++borders;
        EXPECT_EQ(tam.getNeighbourNormal(face, edge), -tam.getNormal(face));
      }
    }
  }
  EXPECT_EQ(borders, 24u);
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

TEST(TopologyAwareMesh, Layouts_HaveTheirSizes)
{
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    const SEDGeometry geometry = build(mesh.soup);
    const TopologyAwareMesh tam(geometry);
    const std::size_t faces = tam.countFaces();
    EXPECT_EQ(tam.getPackedSize(TAMLayout::Full), 3 * 84 * faces);
    EXPECT_EQ(tam.getPackedSize(TAMLayout::Half), 3 * 48 * faces);
    for (const TAMLayout layout : {TAMLayout::Full, TAMLayout::Half, TAMLayout::Shared})
    {
      EXPECT_EQ(tam.pack(geometry, layout).size(), tam.getPackedSize(layout));
    }
    const double original = static_cast<double>(getOriginalSize(geometry.getPositions().size(), faces));
    EXPECT_LE(static_cast<double>(tam.getPackedSize(TAMLayout::Shared)) / original, 0.77);
  }
  // The paper's own reckoning: unshared vertices without indices, and two vertices a face with them.
  const SEDGeometry geometry = build(makeOpenCylinder(9));
  const TopologyAwareMesh tam(geometry);
  const double half =
      static_cast<double>(tam.getPackedSize(TAMLayout::Half)) / static_cast<double>(tam.countFaces());
  EXPECT_NEAR(half / (3.0 * 44), 1.09, 0.005);
  EXPECT_NEAR(half / (static_cast<double>(getOriginalSize(20000, 10000)) / 10000), 1.53, 0.005);
}

TEST(TopologyAwareMesh, Pack_FullHoldsPositionCornersAndNormals)
{
  const SEDGeometry geometry = build(makeOpenCylinder(9));
  const TopologyAwareMesh tam(geometry);
  const std::vector<unsigned char> full = tam.pack(geometry, TAMLayout::Full);
  for (std::size_t face = 0; face < tam.countFaces(); ++face)
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const std::size_t vertex = 84 * (3 * face + corner);
      const auto& corners = geometry.getTriangles()[face];
      EXPECT_EQ(readVector(full, vertex), geometry.getPositions()[corners[corner]]);
      for (std::size_t k = 0; k < 3; ++k)
      {
        EXPECT_EQ(readVector(full, vertex + 12 + 12 * k), geometry.getPositions()[corners[k]]);
        EXPECT_EQ(readVector(full, vertex + 48 + 12 * k), tam.getNeighbourNormal(face, k));
      }
    }
  }
}

TEST(TopologyAwareMesh, PackedNormals_KeepTheirDirection)
{
  std::mt19937 random(3);
  for (int i = 0; i < 10000; ++i)
  {
    const glm::vec3 normal = glm::normalize(glm::vec3(randomPoint(random, 1.0)));
    EXPECT_LT(glm::distance(unpackNormal(packNormal(normal)), normal), 1e-4f);
  }
  for (const glm::vec3& axis :
       {glm::vec3(1, 0, 0), glm::vec3(0, -1, 0), glm::vec3(0, 0, -1), glm::vec3(0, 0, 1)})
  {
    EXPECT_EQ(unpackNormal(packNormal(axis)), axis);
  }
}

} // namespace shadow::test
