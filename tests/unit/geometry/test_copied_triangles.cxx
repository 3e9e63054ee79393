// Triangles that are stored more than once: for lines they are one sheet, for volumes each counts.

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "SilhouetteFinder.h"
#include "TestMeshes.h"
#include "TopologyAwareMesh.h"

namespace shadow::test
{

namespace
{

SEDGeometry buildForLines(const TriangleSoup& soup, const SEDGeometry* previous = nullptr)
{
  SEDGeometryOptions options;
  options.copiesCountOnce = true;
  options.previous = previous;
  return build(soup, options);
}

/// Where lines are, each as often as it is found.
using Places = std::multiset<std::array<float, 6>>;

Places placesOf(const SEDGeometry& geometry, const std::vector<FaceEdges>& lines)
{
  Places places;
  for (const FaceEdges& line : lines)
  {
    for (std::size_t edge = 0; edge < 3; ++edge)
    {
      if ((line.edges >> edge & 9u) != 0)
      {
        const auto& corners = geometry.getTriangles()[line.face];
        const glm::vec3& from = geometry.getPositions()[corners[edge]];
        const glm::vec3& to = geometry.getPositions()[corners[(edge + 1) % 3]];
        const std::array<float, 6> there = {from.x, from.y, from.z, to.x, to.y, to.z};
        const std::array<float, 6> back = {to.x, to.y, to.z, from.x, from.y, from.z};
        places.insert(std::min(there, back));
      }
    }
  }
  return places;
}

Places findLines(const SEDGeometry& geometry, const glm::dvec3& eye, bool border, double creaseDegrees)
{
  const TopologyAwareMesh mesh(geometry);
  const auto finder = makeSilhouetteFinder(SilhouetteMethod::Auto);
  LightFacing facing;
  finder->face(geometry, glm::dvec4(eye, 1.0), facing);
  mesh.completeFacing(facing);
  const std::vector<FaceEdges> creases = mesh.findCreases(geometry, creaseDegrees);
  std::vector<FaceEdges> lines;
  mesh.findLines(geometry, facing, {true, border, &creases}, lines);
  return placesOf(geometry, lines);
}

/// Edges that may be lines by what is known without an eye.
Places findPossible(const SEDGeometry& geometry)
{
  const TopologyAwareMesh mesh(geometry);
  std::vector<FaceEdges> possible;
  for (std::uint32_t face = 0; face < mesh.countFaces(); ++face)
  {
    for (std::uint32_t edge = 0; edge < 3; ++edge)
    {
      if (mesh.getFate(geometry, face, edge) != EdgeFate::Never)
      {
        possible.push_back({face, 1u << edge});
      }
    }
  }
  return placesOf(geometry, possible);
}

void expectSameLines(const SEDGeometry& one, const SEDGeometry& other, std::mt19937& random)
{
  for (int eye = 0; eye < 10; ++eye)
  {
    const glm::dvec3 at = randomPoint(random, 6.0);
    for (const bool border : {true, false})
    {
      EXPECT_EQ(findLines(one, at, border, 180.0), findLines(other, at, border, 180.0)) << eye;
    }
    EXPECT_EQ(findLines(one, at, true, 20.0), findLines(other, at, true, 20.0)) << eye;
  }
  EXPECT_EQ(findPossible(one), findPossible(other));
}

/// Manifold meshes, open and closed: those of which no other order of the triangles makes another surface.
std::vector<NamedMesh> makeManifolds()
{
  std::vector<NamedMesh> meshes = makeClosedMeshes();
  meshes.push_back({"square", makeFlatSquare(8)});
  meshes.push_back({"quad", makeFlatSquare(1)});
  meshes.push_back({"cylinder", makeOpenCylinder(13)});
  TriangleSoup half = makeSphere(1.0, 12, 8);
  half.triangles.resize(half.triangles.size() / 2);
  meshes.push_back({"half a sphere", half});
  return meshes;
}

enum class Winding
{
  Same,
  Opposite,
  Random
};

TriangleSoup storeAgain(TriangleSoup soup, std::size_t triangles, std::size_t copies, Winding winding)
{
  TriangleSoup again = soup;
  std::shuffle(again.triangles.begin(), again.triangles.end(), std::mt19937(7));
  again.triangles.resize(std::min(triangles, again.triangles.size()));
  if (winding == Winding::Opposite)
  {
    turnInsideOut(again);
  }
  for (std::size_t copy = 0; copy < copies; ++copy)
  {
    if (winding == Winding::Random)
    {
      turnRandomly(again, static_cast<std::uint32_t>(copy));
    }
    append(soup, again);
  }
  return soup;
}

std::size_t countCopies(const SEDGeometry& geometry)
{
  return geometry.getCopies().countSet();
}

} // namespace

TEST(CopiedTriangles, AnyOfThemStoredAgain_LinesOfTheMeshStoredOnce)
{
  std::mt19937 random(1);
  constexpr std::size_t all = 1000000;
  for (const NamedMesh& mesh : makeManifolds())
  {
    const SEDGeometry once = buildForLines(mesh.soup);
    EXPECT_EQ(countCopies(once), 0u) << mesh.name;
    for (const Winding winding : {Winding::Same, Winding::Opposite, Winding::Random})
    {
      for (const std::size_t copies : {1u, 2u})
      {
        for (const std::size_t triangles : {std::size_t{1}, mesh.soup.triangles.size() / 3, all})
        {
          SCOPED_TRACE(mesh.name + ", winding " + std::to_string(static_cast<int>(winding)) + ", " +
                       std::to_string(triangles) + " stored " + std::to_string(copies) + " times more");
          const TriangleSoup soup = storeAgain(mesh.soup, triangles, copies, winding);
          const SEDGeometry geometry = buildForLines(soup);
          EXPECT_EQ(countCopies(geometry), soup.triangles.size() - mesh.soup.triangles.size());
          EXPECT_EQ(geometry.getTriangles().size(), soup.triangles.size()) << "none is lost";
          expectSameLines(geometry, once, random);
        }
      }
    }
  }
}

TEST(CopiedTriangles, PointsOfTheirOwn_AreCopiesStill)
{
  const TriangleSoup square = makeFlatSquare(8);
  const TriangleSoup soup = makeUnshared(storeAgain(square, 1000, 1, Winding::Opposite));
  EXPECT_EQ(countCopies(buildForLines(soup)), square.triangles.size());
}

TEST(CopiedTriangles, WallBetweenSolids_StaysTheWallOfEach)
{
  for (const int cubes : {2, 3})
  {
    TriangleSoup soup;
    for (int cube = 0; cube < cubes; ++cube)
    {
      // Every second one mirrored, so that both have the wall's diagonal.
      TriangleSoup next = makeCube();
      for (glm::dvec3& point : next.points)
      {
        point.x = 2.0 * cube + (cube % 2 == 0 ? point.x : -point.x);
      }
      if (cube % 2 != 0)
      {
        turnInsideOut(next);
      }
      append(soup, next);
    }
    const std::size_t wallEdges = 5 * static_cast<std::size_t>(cubes - 1);
    EXPECT_EQ(build(soup).getReport().nonManifoldEdges, wallEdges) << "four sides and a diagonal, shared";
    const SEDGeometry geometry = buildForLines(soup);
    EXPECT_EQ(countCopies(geometry), 0u);
    EXPECT_TRUE(geometry.isClosed());
    turnRandomly(soup, 5);
    EXPECT_EQ(countCopies(buildForLines(soup)), 0u) << "whatever the winding";
  }
}

TEST(CopiedTriangles, SheetStoredTwiceThatTouchesASolid_IsASheet)
{
  TriangleSoup fin;
  fin.points = {{1.0, 1.0, -1.0}, {1.0, 1.0, 1.0}, {3.0, 2.0, 1.0}, {3.0, 2.0, -1.0}};
  fin.triangles = {{0, 1, 2}, {0, 2, 3}};
  TriangleSoup soup = makeCube();
  append(soup, storeAgain(fin, 2, 1, Winding::Opposite));
  EXPECT_EQ(countCopies(buildForLines(soup)), 2u);
}

TEST(CopiedTriangles, ForVolumes_EachCounts)
{
  const TriangleSoup soup = storeAgain(makeFlatSquare(4), 1000, 1, Winding::Opposite);
  const SEDGeometry geometry = build(soup);
  EXPECT_EQ(countCopies(geometry), 0u);
  EXPECT_EQ(geometry.getReport().nonManifoldEdges, 40u) << "every inner edge has four triangles";
  EXPECT_EQ(buildForLines(soup).getReport().nonManifoldEdges, 0u);
}

TEST(CopiedTriangles, Deformed_IsTheSameMeshMoved)
{
  const TriangleSoup square = makeFlatSquare(8);
  TriangleSoup soup = storeAgain(square, 40, 1, Winding::Opposite);
  const SEDGeometry before = buildForLines(soup);
  TriangleSoup bent = square;
  for (TriangleSoup* mesh : {&soup, &bent})
  {
    for (glm::dvec3& point : mesh->points)
    {
      point.z += 0.3 * point.x * point.x + 0.2 * point.y;
    }
  }
  const SEDGeometry after = buildForLines(soup, &before);
  EXPECT_TRUE(isSameMeshMoved(before, after));
  EXPECT_EQ(countCopies(after), 40u);
  std::mt19937 random(3);
  expectSameLines(after, buildForLines(bent), random);
}

TEST(CopiedTriangles, OthersThanBefore_IsAnotherMesh)
{
  const TriangleSoup square = makeFlatSquare(4);
  TriangleSoup soup = square;
  append(soup, square);
  const SEDGeometry before = buildForLines(soup);
  // The last triangles come off.
  const std::size_t points = square.points.size();
  for (std::size_t point = points; point < soup.points.size(); ++point)
  {
    soup.points[point].z += soup.points[point].x > 0.5 ? 0.25 : 0.0;
  }
  const SEDGeometry after = buildForLines(soup, &before);
  EXPECT_FALSE(isSameMeshMoved(before, after));
  EXPECT_LT(countCopies(after), countCopies(before));
  const SEDGeometry fresh = buildForLines(soup);
  std::mt19937 random(4);
  expectSameLines(after, fresh, random);
}

} // namespace shadow::test
