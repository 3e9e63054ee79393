#include "OperationTables.h"

#include <algorithm>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "BruteForceSilhouette.h"
#include "PaperFormulas.h"
#include "PaperObjects.h"
#include "PublishedForms.h"
#include "TestMeshes.h"

namespace shadow::benchmarks
{

namespace
{

constexpr int lights = 100;

using Form = std::vector<DirectedEdge> (*)(const PolygonMesh&, const glm::dvec4&, Operations&);

/// Directed edges by brute force; where @p mesh has merged triangles, what is left between its faces.
std::vector<DirectedEdge> findByBruteForce(const SEDGeometry& geometry, const glm::dvec4& lightMC)
{
  std::vector<DirectedEdge> edges;
  for (const SilhouetteEdge& edge :
       BruteForceSilhouette().find(geometry, computeFacing(geometry, lightMC), Casting::LightFacing))
  {
    edges.push_back({edge.from, edge.to});
  }
  return edges;
}

/// A point light outside the mesh.
glm::dvec4 makeLight(std::mt19937& random)
{
  return {4.0 * glm::normalize(test::randomPoint(random, 1.0)), 1.0};
}

/// Mean over 100 lights. @return false when a silhouette differs from brute force's
bool count(Form form, const SEDGeometry& geometry, const PolygonMesh& mesh, Operations& mean)
{
  std::mt19937 random(31);
  Operations sum;
  for (int light = 0; light < lights; ++light)
  {
    const glm::dvec4 lightMC = makeLight(random);
    std::vector<DirectedEdge> found = form(mesh, lightMC, sum);
    std::vector<DirectedEdge> expected = findByBruteForce(geometry, lightMC);
    std::sort(found.begin(), found.end());
    std::sort(expected.begin(), expected.end());
    if (found != expected)
    {
      std::fprintf(stderr, "a published form finds another silhouette than brute force\n");
      return false;
    }
  }
  mean = sum / lights;
  return true;
}

void printRow(const std::string& what, const Operations& operations)
{
  std::printf("  %-44s %12.0f %12.0f %12.0f %12.0f %10.0f\n", what.c_str(), operations.additions,
              operations.multiplications, operations.comparisons, operations.reads, operations.writes);
}

void printHead(std::uint32_t n, std::uint32_t m, const SEDGeometry& geometry, const PolygonMesh& triangles,
               const PolygonMesh& polygons)
{
  std::printf(
      "\nn = %u, m = %u. The solid: %zu flat faces of %.2f sides on average, %zu edges, %zu vertices;\n"
      "triangulated %zu faces, %zu edges. The formulas: %u faces, %u edges.\n",
      n, m, polygons.faces.size(), polygons.getMeanSides(), polygons.edges.size(),
      geometry.getPositions().size(), triangles.faces.size(), triangles.edges.size(), n, 6 * n);
  std::printf("  %-44s %12s %12s %12s %12s %10s\n", "mean of 100 lights", "additions", "multiplic.",
              "comparisons", "reads", "writes");
}

bool printTable(std::uint32_t n, std::uint32_t m)
{
  const SEDGeometry geometry = test::build(makePrism(n, m));
  const PolygonMesh triangles = makeTriangleMesh(geometry);
  const PolygonMesh polygons = makeMergedMesh(geometry, findFlatRegions(geometry));
  Operations triangular;
  Operations triangularOnTriangles;
  Operations visible;
  Operations visibleOnTriangles;
  if (!count(findByTriangular, geometry, polygons, triangular) ||
      !count(findByTriangular, geometry, triangles, triangularOnTriangles) ||
      !count(findByVisibleNonVisible, geometry, polygons, visible) ||
      !count(findByVisibleNonVisible, geometry, triangles, visibleOnTriangles))
  {
    return false;
  }
  printHead(n, m, geometry, triangles, polygons);
  printRow("TA   the paper's formula", paperTriangular(n, m));
  printRow("     counted, on the flat faces", triangular);
  printRow("     counted, on the triangles", triangularOnTriangles);
  printRow("VnV  the paper's formula", paperVisibleNonVisible(n, m));
  printRow("     counted, on the flat faces", visible);
  printRow("     counted, on the triangles", visibleOnTriangles);
  printRow("HSD  the paper's formula", paperHybrid(n, m));
  printRow("     counted, on flat faces merged from triangles", triangular);
  std::printf("  TA over HSD, comparisons: formula %.1f, counted (triangles over merged faces) %.1f\n",
              paperTriangular(n, m).comparisons / paperHybrid(n, m).comparisons,
              triangularOnTriangles.comparisons / triangular.comparisons);
  return true;
}

void printReasons()
{
  std::printf(R"(
Where the paper's counts and these differ, and why
- What n and m are. The paper calls n the number of vertices, but puts n for the faces and 6 n for the edges (two
  vertices a face, as it cites, and three edges a vertex; on triangle meshes it is two faces a vertex). m is the
  mean number of sides of a face. Here n is the number of faces, as the formulas have it. A closed solid of n
  faces with m sides then has m n / 2 edges, not 6 n: that would take 12 sides a face.
- Facing. The paper counts 8 A, 10 M, 8 R a face: 3 M for the cross product, which takes 6, and none of the 6 A
  that make edges from vertices. Counted here: 14 A, 12 M, 1 C, 13 R (9 coordinates, 4 of the light).
- TA, search. The formula looks through all 6 n edges for each side of every face. The list only ever holds the
  border of the faces done so far, a search ends where it finds something, and faces that the light does not see
  put nothing in. Hence some twenty times fewer comparisons and reads.
- TA, other. Reversing an edge is counted as a multiplication (m n M); it swaps two indices. 2 m n W counts two
  writes for each side of each face; it is one for a side of a visible face. The n comparisons of the facing
  tests are in the paper's derivation and missing in its sum.
- VnV. Facing is computed for every edge and face, in the formula and here, so that the counts differ by the
  number of edges alone (6 n or m n / 2), and by the cost of a facing test. Looking for the edge among the sides
  of a visible face is not in the formula; it is most of the comparisons here. The formula writes every edge, here
  only those of the silhouette are written.
- HSD. The formula is TA's with the m sides of a face taken for one: one search a face. But each side of a merged
  polygon borders on something else and has to be looked up, so HSD does what TA does on the same polygons. What
  it saves is what triangulation adds: see the counts on the triangles. Merging is done once and not counted.
)");
}

} // namespace

bool printOperationTables()
{
  std::printf("Published forms (list search), counted; formulas of Kolivand & Sunar 2011, chapter 6\n");
  if (!printTable(10, 5) || !printTable(100, 10))
  {
    return false;
  }
  printReasons();
  return true;
}

} // namespace shadow::benchmarks
