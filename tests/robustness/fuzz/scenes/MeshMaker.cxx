#include "MeshMaker.h"

#include <algorithm>

namespace shadow::fuzz
{

namespace
{

using Triangles = std::vector<FuzzTriangle>;

Triangles makeSoup(FuzzRandom& random)
{
  Triangles mesh(1 + random.below(random.chance(0.5) ? 4 : 40));
  const double size = random.chance(0.5) ? 1.0 : random.between(0.1, 0.6);
  for (FuzzTriangle& triangle : mesh)
  {
    const glm::dvec3 centre = random.inCube(1.0 - size);
    for (glm::dvec3& corner : triangle)
    {
      corner = centre + random.inCube(size);
    }
  }
  return mesh;
}

/// Corners, edges and planes are shared by chance, and some triangles have no area.
Triangles makeLatticeSoup(FuzzRandom& random)
{
  const glm::dvec3 step(random.between(0.2, 0.6), random.between(0.2, 0.6), random.between(0.2, 0.6));
  const int reach = random.integer(1, 3);
  Triangles mesh(1 + random.below(24));
  for (FuzzTriangle& triangle : mesh)
  {
    for (glm::dvec3& corner : triangle)
    {
      const int x = random.integer(-reach, reach);
      const int y = random.integer(-reach, reach);
      corner = step * glm::dvec3(x, y, random.integer(-reach, reach));
    }
  }
  return mesh;
}

Triangles makeSlivers(FuzzRandom& random)
{
  Triangles mesh(1 + random.below(12));
  for (FuzzTriangle& triangle : mesh)
  {
    const glm::dvec3 start = random.inCube(1.0);
    const glm::dvec3 end = random.inCube(1.0);
    const glm::dvec3 between = start + random.between(-0.1, 1.1) * (end - start);
    triangle = {start, end, between + powerOfTen(-random.integer(1, 8)) * random.direction()};
    std::rotate(triangle.begin(), triangle.begin() + random.integer(0, 2), triangle.end());
  }
  return mesh;
}

/// A point of the unit circle in the plane of x and y, a share of a turn from the x axis; rational.
glm::dvec3 onCircle(int part, int parts)
{
  const int quarter = 4 * part / parts;
  const double u = static_cast<double>(4 * part - quarter * parts) / parts;
  const glm::dvec2 first((1.0 - u * u) / (1.0 + u * u), 2.0 * u / (1.0 + u * u));
  const glm::dvec2 turned = quarter % 2 == 0 ? first : glm::dvec2(-first.y, first.x);
  return {quarter % 4 < 2 ? turned : -turned, 0.0};
}

/// Around one point, whole or in part, flat or a cone.
Triangles makeFan(FuzzRandom& random)
{
  const int parts = random.integer(3, 16);
  const int present = random.chance(0.5) ? parts : random.integer(1, parts);
  const double radius = random.between(0.3, 1.0);
  const glm::dvec3 tip(0.0, 0.0, random.chance(0.3) ? 0.0 : random.between(-1.0, 1.0));
  Triangles mesh;
  for (int part = 0; part < present; ++part)
  {
    mesh.push_back({tip, radius * onCircle(part, parts), radius * onCircle((part + 1) % parts, parts)});
  }
  return mesh;
}

/// Triangles that share one edge.
Triangles makeBook(FuzzRandom& random)
{
  const glm::dvec3 start = random.inCube(1.0);
  const glm::dvec3 end = random.inCube(1.0);
  Triangles mesh(2 + random.below(6));
  for (FuzzTriangle& page : mesh)
  {
    page = {start, end, random.inCube(1.0)};
  }
  return mesh;
}

void addQuad(Triangles& mesh, const std::array<glm::dvec3, 4>& around)
{
  mesh.push_back({around[0], around[1], around[2]});
  mesh.push_back({around[0], around[2], around[3]});
}

/// A sheet with or without bumps.
Triangles makeSheet(FuzzRandom& random)
{
  const int cells = random.integer(1, 7);
  const double bump = random.chance(0.3) ? 0.0 : random.between(0.0, 0.5);
  std::vector<glm::dvec3> points;
  for (int y = 0; y <= cells; ++y)
  {
    for (int x = 0; x <= cells; ++x)
    {
      points.emplace_back(2.0 * x / cells - 1.0, 2.0 * y / cells - 1.0, bump * random.between(-1.0, 1.0));
    }
  }
  Triangles mesh;
  for (int y = 0; y < cells; ++y)
  {
    for (int x = 0; x < cells; ++x)
    {
      const std::size_t at = static_cast<std::size_t>(y) * (cells + 1) + x;
      addQuad(mesh, {points[at], points[at + 1], points[at + cells + 2], points[at + cells + 1]});
    }
  }
  return mesh;
}

/// Closed, normals outwards.
Triangles makeBox(FuzzRandom& random)
{
  const glm::dvec3 half(random.between(0.2, 1.0), random.between(0.2, 1.0), random.between(0.2, 1.0));
  const auto at = [&half](double x, double y, double z) { return half * glm::dvec3(x, y, z); };
  Triangles mesh;
  for (const double s : {-1.0, 1.0})
  {
    addQuad(mesh, {at(s, -s, -1), at(s, s, -1), at(s, s, 1), at(s, -s, 1)});
    addQuad(mesh, {at(-1, s, -s), at(-1, s, s), at(1, s, s), at(1, s, -s)});
    addQuad(mesh, {at(-s, -1, s), at(s, -1, s), at(s, 1, s), at(-s, 1, s)});
  }
  return mesh;
}

/// An octahedron whose triangles are cut in four up to twice, and moved onto the sphere or left flat.
Triangles makeBall(FuzzRandom& random)
{
  Triangles mesh;
  for (const double x : {-1.0, 1.0})
  {
    for (const double y : {-1.0, 1.0})
    {
      for (const double z : {-1.0, 1.0})
      {
        const FuzzTriangle face = {glm::dvec3(x, 0, 0), glm::dvec3(0, y, 0), glm::dvec3(0, 0, z)};
        mesh.push_back(x * y * z > 0.0 ? face : FuzzTriangle{face[0], face[2], face[1]});
      }
    }
  }
  const bool isRound = random.chance(0.7);
  for (int level = random.integer(0, 2); level > 0; --level)
  {
    Triangles finer;
    for (const auto& [a, b, c] : mesh)
    {
      const auto middle = [isRound](const glm::dvec3& p, const glm::dvec3& q)
      { return isRound ? glm::normalize(p + q) : 0.5 * (p + q); };
      const glm::dvec3 ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh = finer;
  }
  return mesh;
}

Triangles makeTorus(FuzzRandom& random)
{
  const int around = random.integer(3, 12);
  const int across = random.integer(3, 8);
  const double minor = random.between(0.1, 0.4);
  const auto at = [&](int i, int j)
  {
    const glm::dvec3 outwards = onCircle(i % around, around);
    const glm::dvec3 section = minor * onCircle(j % across, across);
    return 0.6 * outwards + section.x * outwards + glm::dvec3(0.0, 0.0, section.y);
  };
  Triangles mesh;
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      addQuad(mesh, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

void makeHoles(FuzzRandom& random, Triangles& mesh)
{
  for (std::size_t holes = random.below(std::min<std::size_t>(mesh.size(), 6)); holes > 0; --holes)
  {
    mesh.erase(mesh.begin() + static_cast<std::ptrdiff_t>(random.below(mesh.size())));
  }
}

void mixWinding(FuzzRandom& random, Triangles& mesh)
{
  for (FuzzTriangle& triangle : mesh)
  {
    if (random.chance(0.5))
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
}

void repeatSome(FuzzRandom& random, Triangles& mesh)
{
  for (std::size_t copies = 1 + random.below(mesh.size()); copies > 0; --copies)
  {
    FuzzTriangle triangle = random.pick(mesh);
    if (random.chance(0.5))
    {
      std::swap(triangle[0], triangle[1]);
    }
    mesh.push_back(triangle);
  }
}

/// Turned about a random axis, so that faces lie along no axis.
void turn(FuzzRandom& random, Triangles& mesh)
{
  const glm::dvec3 x = random.direction();
  const glm::dvec3 y = glm::normalize(glm::cross(x, random.direction() + glm::dvec3(1e-3, 2e-3, 3e-3)));
  const glm::dmat3 rotation(x, y, glm::cross(x, y));
  for (FuzzTriangle& triangle : mesh)
  {
    for (glm::dvec3& corner : triangle)
    {
      corner = rotation * corner;
    }
  }
}

} // namespace

std::vector<FuzzTriangle> makeMesh(FuzzRandom& random)
{
  using Maker = Triangles (*)(FuzzRandom&);
  constexpr std::array<Maker, 12> makers = {makeSoup, makeSoup, makeLatticeSoup, makeLatticeSoup,
                                            makeFan,  makeBook, makeSlivers,     makeSheet,
                                            makeBox,  makeBall, makeBall,        makeTorus};
  Triangles mesh = random.pick(makers)(random);
  if (random.chance(0.2))
  {
    makeHoles(random, mesh);
  }
  if (random.chance(0.2))
  {
    mixWinding(random, mesh);
  }
  if (random.chance(0.1))
  {
    repeatSome(random, mesh);
  }
  if (random.chance(0.4))
  {
    turn(random, mesh);
  }
  return mesh;
}

} // namespace shadow::fuzz
