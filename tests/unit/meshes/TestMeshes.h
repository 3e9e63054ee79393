#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "SEDGeometry.h"

namespace shadow::test
{

/// Closed, 12 triangles, normals outwards.
TriangleSoup makeCube(const glm::dvec3& centre = glm::dvec3(0.0), double size = 2.0);

/// Closed, 2 * slices * (stacks - 1) triangles, normals outwards.
TriangleSoup makeSphere(double radius, std::uint32_t slices, std::uint32_t stacks,
                        const glm::dvec3& centre = glm::dvec3(0.0));

/// Closed, around the z axis, 2 * around * across triangles, normals outwards.
TriangleSoup makeTorus(double majorRadius, double minorRadius, std::uint32_t around, std::uint32_t across);

/// A square from -1 to 1 at height 0, seen from above, of 2 * divisions * divisions triangles. Point
/// (divisions + 1) * y + x is the one in column x of row y.
TriangleSoup makeFlatSquare(std::uint32_t divisions);

/// A strip bent into a ring of two borders, without lids.
TriangleSoup makeOpenCylinder(std::uint32_t slices);

/// A strip bent into a ring after half a turn: one border, cannot be oriented.
TriangleSoup makeMoebius(std::uint32_t segments);

/// Triangles that all share one edge, like the pages of a book, wound alike.
TriangleSoup makeBook(std::uint32_t pages);

/// Two tetrahedra that touch in one vertex.
TriangleSoup makeBowTie();

/// Two cubes that touch along one edge.
TriangleSoup makeCubesSharingAnEdge();

/// Triangles in the cube from -1 to 1 that have nothing to do with each other.
TriangleSoup makeRandomSoup(std::uint32_t triangles, std::uint32_t seed);

/// Squares from -1 to 1 in x and y, stacked along z with unit distance, two triangles each.
TriangleSoup makePlates(std::uint32_t plates);

/// Adds the triangles of another mesh.
void append(TriangleSoup& soup, const TriangleSoup& other);

/// Winds every triangle the other way.
void turnInsideOut(TriangleSoup& soup);

/// Winds every second triangle, chosen at random, the other way, and starts each at a random corner.
void turnRandomly(TriangleSoup& soup, std::uint32_t seed);

/// Gives every triangle points of its own, as an STL file does.
TriangleSoup makeUnshared(const TriangleSoup& soup);

struct NamedMesh
{
  std::string name;
  TriangleSoup soup;
};

/// Closed meshes without self-intersections that need no cut.
std::vector<NamedMesh> makeClosedMeshes();

/// The closed meshes, and open, non-orientable, non-manifold and random ones.
std::vector<NamedMesh> makeAllMeshes();

/// The geometry of a soup that must be usable: throws std::runtime_error with the reason if it is not.
SEDGeometry build(const TriangleSoup& soup, const SEDGeometryOptions& options = {});

/// A random point in the cube from -reach to reach.
glm::dvec3 randomPoint(std::mt19937& random, double reach);

} // namespace shadow::test
