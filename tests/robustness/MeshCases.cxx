// What the triangles are like.
#include <cmath>

#include "HardCase.h"
#include "HardScene.h"

namespace shadow::robustness
{

namespace
{

// A disc of needles around its middle, each a thousand times as long as it is wide, and a plate of parallel
// ones.
void slivers(HardScene& scene)
{
  TriangleSoup soup;
  const int needles = 6000;
  const double turn = 2.0 * 3.14159265358979323846 / needles;
  soup.points.emplace_back(0.0, 1.0, 0.0);
  for (int i = 0; i < needles; ++i)
  {
    soup.points.emplace_back(std::cos(i * turn), 1.0 + 0.2 * std::sin(3 * i * turn), std::sin(i * turn));
    const auto here = static_cast<std::uint32_t>(1 + i);
    soup.triangles.push_back({0, here, static_cast<std::uint32_t>(1 + (i + 1) % needles)});
  }
  for (int i = 0; i < 2000; ++i)
  {
    test::append(soup, makeQuad({-2.0, 0.5 + 5e-4 * i, 0.5}, {0.0, 5e-4, 0.0}, {1.0, 0.0, 0.4}));
  }
  scene.show(soup);
}

// Needles so thin that their normals are nothing but rounding, in an otherwise sound mesh.
void thinnestSlivers(HardScene& scene)
{
  TriangleSoup soup = makeRing();
  for (int i = 0; i < 50; ++i)
  {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    const glm::dvec3 from(-1.0 + 0.04 * i, 2.0, 0.3);
    const glm::dvec3 to(-0.7 + 0.05 * i, 1.1, -0.9);
    soup.points.insert(soup.points.end(), {from, to, 0.37 * from + 0.63 * to + glm::dvec3(0.0, 1e-13, 0.0)});
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  scene.show(soup);
}

void zeroAreaTriangles(HardScene& scene)
{
  TriangleSoup soup = makeRing();
  const auto points = static_cast<std::uint32_t>(soup.points.size());
  for (std::uint32_t i = 0; i + 7 < points; i += 7)
  {
    soup.triangles.push_back({i, i, i + 1});     // one point twice
    soup.triangles.push_back({i, i, i});         // one point
    soup.triangles.push_back({i, i + 1, i + 1}); // an edge of the mesh, again
  }
  // Three different points on a line, along edges of a cube and on their own.
  test::append(soup, test::makeCube({1.6, 0.4, 0.6}, 0.5));
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  soup.points.insert(soup.points.end(), {{1.35, 0.15, 0.85}, {1.6, 0.15, 0.85}, {1.85, 0.15, 0.85}});
  soup.points.insert(soup.points.end(), {{-1.0, 2.0, 0.0}, {0.0, 2.0, 0.5}, {1.0, 2.0, 1.0}});
  soup.triangles.push_back({first, first + 1, first + 2});
  soup.triangles.push_back({first + 3, first + 4, first + 5});
  soup.triangles.push_back({first + 3, first + 5, first + 4});
  scene.show(soup);
}

void duplicateTriangles(HardScene& scene)
{
  TriangleSoup soup = makeRing();
  const std::vector<std::array<std::uint32_t, 3>> once = soup.triangles;
  for (std::size_t i = 0; i < once.size(); i += 3)
  {
    soup.triangles.push_back(once[i]); // every third again
  }
  for (std::size_t i = 0; i < once.size(); i += 5)
  {
    soup.triangles.push_back({once[i][1], once[i][2], once[i][0]});
    soup.triangles.push_back({once[i][1], once[i][0], once[i][2]}); // and turned round
  }
  scene.show(soup);
}

void wholeMeshTwice(HardScene& scene)
{
  TriangleSoup soup = makeRing();
  test::append(soup, makeRing());
  scene.show(soup);
}

void duplicateVertices(HardScene& scene)
{
  scene.show(test::makeUnshared(makeRing()));
}

// One side of the seam has a point that the other side has not; in a closed box and in a bent sheet.
void tJunctions(HardScene& scene)
{
  const glm::dvec3 x(1.0, 0.0, 0.0), y(0.0, 1.0, 0.0), z(0.0, 0.0, 1.0);
  const glm::dvec3 low(-1.8, 0.0, -0.5);
  TriangleSoup soup = makeQuad(low, y, x);
  test::append(soup, makeQuad(low, x, z));
  test::append(soup, makeQuad(low, z, y));
  test::append(soup, makeGrid(low + x + y + z, -x, -y, 3));
  test::append(soup, makeGrid(low + x + y + z, -z, -x, 7));
  test::append(soup, makeQuad(low + x + y + z, -y, -z));
  test::append(soup, makeGrid({0.2, 0.7, -0.5}, {1.0, 0.3, 0.0}, {0.0, 0.1, 1.0}, 5));
  test::append(soup, makeQuad({1.2, 1.0, -0.5}, {0.8, -0.4, 0.0}, {0.0, 0.1, 1.0}));
  scene.show(soup);
}

void openDome(HardScene& scene)
{
  scene.show(moved(makeDome(1.0, 48), {0.0, 0.5, 0.0}));
}

void openBowl(HardScene& scene)
{
  TriangleSoup bowl = makeDome(1.0, 48);
  for (glm::dvec3& point : bowl.points)
  {
    point.y = 1.2 - point.y;
  }
  scene.show(bowl);
}

void openCylinder(HardScene& scene)
{
  scene.show(moved(upright(scaled(test::makeOpenCylinder(48), 0.8)), {0.0, 0.9, 0.0}));
}

void singleTriangle(HardScene& scene)
{
  TriangleSoup soup;
  soup.points = {{-1.0, 0.4, 0.5}, {1.2, 0.9, 0.3}, {0.1, 1.3, -0.9}};
  soup.triangles = {{0, 1, 2}};
  scene.show(soup);
}

void moebiusStrip(HardScene& scene)
{
  scene.show(moved(upright(test::makeMoebius(48)), {0.0, 0.9, 0.0}));
}

void manyTrianglesOnOneEdge(HardScene& scene)
{
  scene.show(moved(upright(test::makeBook(7)), {0.0, 1.2, 0.0}));
}

void bowTie(HardScene& scene)
{
  scene.show(moved(upright(test::makeBowTie()), {0.0, 1.1, 0.0}));
}

void cubesSharingAnEdge(HardScene& scene)
{
  scene.show(moved(upright(scaled(test::makeCubesSharingAnEdge(), 0.5)), {0.0, 0.6, 0.0}));
}

void inconsistentWinding(HardScene& scene)
{
  TriangleSoup soup = makeRing();
  test::turnRandomly(soup, 7);
  scene.show(soup);
}

void inconsistentWindingUnshared(HardScene& scene)
{
  TriangleSoup soup = test::makeUnshared(makeRing());
  test::turnRandomly(soup, 11);
  scene.show(soup);
}

void insideOut(HardScene& scene)
{
  TriangleSoup soup = makeRing();
  test::turnInsideOut(soup);
  scene.show(soup);
}

// Two closed parts, one of them inside out.
void halfInsideOut(HardScene& scene)
{
  TriangleSoup soup = test::makeCube({-1.2, 0.6, 0.0}, 1.0);
  test::turnInsideOut(soup);
  test::append(soup, moved(upright(test::makeSphere(0.6, 32, 16)), {0.8, 0.7, 0.2}));
  scene.show(soup);
}

void selfIntersecting(HardScene& scene)
{
  TriangleSoup soup = makeRing();
  test::append(soup, test::makeCube({0.7, 0.9, 0.1}, 1.1));
  test::append(soup, moved(test::makeSphere(0.5, 24, 12), {0.3, 1.1, 0.5}));
  scene.show(soup);
}

void intersectingActors(HardScene& scene)
{
  scene.addMesh(makeRing());
  scene.addMesh(test::makeCube({0.7, 0.9, 0.1}, 1.1));
  scene.addMesh(moved(test::makeSphere(0.5, 24, 12), {0.3, 1.1, 0.5}));
  scene.finish();
}

void randomSoup(HardScene& scene)
{
  scene.show(moved(test::makeRandomSoup(80, 5), {0.0, 1.2, 0.0}));
}

} // namespace

std::vector<HardCase> meshCases()
{
  return {
      {"Slivers", slivers},
      {"ThinnestSlivers", thinnestSlivers},
      {"ZeroAreaTriangles", zeroAreaTriangles},
      {"DuplicateTriangles", duplicateTriangles},
      {"WholeMeshTwice", wholeMeshTwice},
      {"DuplicateVertices", duplicateVertices},
      {"TJunctions", tJunctions},
      {"OpenDome", openDome},
      {"OpenBowl", openBowl},
      {"OpenCylinder", openCylinder},
      {"SingleTriangle", singleTriangle},
      {"MoebiusStrip", moebiusStrip},
      {"ManyTrianglesOnOneEdge", manyTrianglesOnOneEdge},
      {"BowTie", bowTie},
      {"CubesSharingAnEdge", cubesSharingAnEdge},
      {"InconsistentWinding", inconsistentWinding},
      {"InconsistentWindingUnshared", inconsistentWindingUnshared},
      {"InsideOut", insideOut},
      {"HalfInsideOut", halfInsideOut},
      {"SelfIntersecting", selfIntersecting},
      {"IntersectingActors", intersectingActors},
      {"RandomSoup", randomSoup},
  };
}

} // namespace shadow::robustness
