#include "TestMeshes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace shadow::test
{

namespace
{

constexpr double pi = 3.14159265358979323846;

void addQuad(TriangleSoup& soup, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
{
  soup.triangles.push_back({a, b, c});
  soup.triangles.push_back({a, c, d});
}

} // namespace

TriangleSoup makeCube(const glm::dvec3& centre, double size)
{
  TriangleSoup soup;
  for (int corner = 0; corner < 8; ++corner)
  {
    soup.points.push_back(
        centre + size * (glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1) - glm::dvec3(0.5)));
  }
  addQuad(soup, 0, 2, 3, 1);
  addQuad(soup, 4, 5, 7, 6);
  addQuad(soup, 0, 1, 5, 4);
  addQuad(soup, 2, 6, 7, 3);
  addQuad(soup, 0, 4, 6, 2);
  addQuad(soup, 1, 3, 7, 5);
  return soup;
}

TriangleSoup makeSphere(double radius, std::uint32_t slices, std::uint32_t stacks, const glm::dvec3& centre)
{
  TriangleSoup soup;
  soup.points.push_back(centre + glm::dvec3(0, 0, radius));
  for (std::uint32_t stack = 1; stack < stacks; ++stack)
  {
    const double down = pi * stack / stacks;
    for (std::uint32_t slice = 0; slice < slices; ++slice)
    {
      const double around = 2.0 * pi * slice / slices;
      soup.points.push_back(centre + radius * glm::dvec3(std::sin(down) * std::cos(around),
                                                         std::sin(down) * std::sin(around), std::cos(down)));
    }
  }
  soup.points.push_back(centre - glm::dvec3(0, 0, radius));
  const auto last = static_cast<std::uint32_t>(soup.points.size() - 1);
  for (std::uint32_t slice = 0; slice < slices; ++slice)
  {
    const std::uint32_t next = (slice + 1) % slices;
    soup.triangles.push_back({0, 1 + slice, 1 + next});
    for (std::uint32_t ring = 1; ring + slices < last; ring += slices)
    {
      addQuad(soup, ring + slice, ring + slices + slice, ring + slices + next, ring + next);
    }
    soup.triangles.push_back({last, last - slices + next, last - slices + slice});
  }
  return soup;
}

TriangleSoup makeTorus(double majorRadius, double minorRadius, std::uint32_t around, std::uint32_t across)
{
  TriangleSoup soup;
  for (std::uint32_t i = 0; i < around; ++i)
  {
    const double u = 2.0 * pi * i / around;
    for (std::uint32_t j = 0; j < across; ++j)
    {
      const double v = 2.0 * pi * j / across;
      const double reach = majorRadius + minorRadius * std::cos(v);
      soup.points.emplace_back(reach * std::cos(u), reach * std::sin(u), minorRadius * std::sin(v));
    }
  }
  for (std::uint32_t i = 0; i < around; ++i)
  {
    const std::uint32_t here = i * across;
    const std::uint32_t there = (i + 1) % around * across;
    for (std::uint32_t j = 0; j < across; ++j)
    {
      const std::uint32_t next = (j + 1) % across;
      addQuad(soup, here + j, there + j, there + next, here + next);
    }
  }
  return soup;
}

TriangleSoup makeFlatSquare(std::uint32_t divisions)
{
  TriangleSoup soup;
  const std::uint32_t columns = divisions + 1;
  const double step = 2.0 / divisions;
  for (std::uint32_t y = 0; y < columns; ++y)
  {
    for (std::uint32_t x = 0; x < columns; ++x)
    {
      soup.points.emplace_back(step * x - 1.0, step * y - 1.0, 0.0);
    }
  }
  for (std::uint32_t y = 0; y < divisions; ++y)
  {
    for (std::uint32_t x = 0; x < divisions; ++x)
    {
      const std::uint32_t first = y * columns + x;
      addQuad(soup, first, first + 1, first + columns + 1, first + columns);
    }
  }
  return soup;
}

TriangleSoup makeOpenCylinder(std::uint32_t slices)
{
  TriangleSoup soup;
  for (std::uint32_t slice = 0; slice < slices; ++slice)
  {
    const double angle = 2.0 * pi * slice / slices;
    soup.points.emplace_back(std::cos(angle), std::sin(angle), -1.0);
    soup.points.emplace_back(std::cos(angle), std::sin(angle), 1.0);
    const std::uint32_t next = (slice + 1) % slices;
    addQuad(soup, 2 * slice, 2 * next, 2 * next + 1, 2 * slice + 1);
  }
  return soup;
}

TriangleSoup makeMoebius(std::uint32_t segments)
{
  TriangleSoup soup;
  for (std::uint32_t segment = 0; segment < segments; ++segment)
  {
    const double angle = 2.0 * pi * segment / segments;
    for (const double side : {-0.4, 0.4})
    {
      const double reach = 1.0 + side * std::cos(0.5 * angle);
      soup.points.emplace_back(reach * std::cos(angle), reach * std::sin(angle),
                               side * std::sin(0.5 * angle));
    }
    const std::uint32_t here = 2 * segment;
    if (segment + 1 < segments)
    {
      addQuad(soup, here, here + 2, here + 3, here + 1);
    }
    else
    {
      addQuad(soup, here, 1, 0, here + 1);
    }
  }
  return soup;
}

TriangleSoup makeBook(std::uint32_t pages)
{
  TriangleSoup soup;
  soup.points = {{0, 0, -1}, {0, 0, 1}};
  for (std::uint32_t page = 0; page < pages; ++page)
  {
    const double angle = 2.0 * pi * page / pages;
    soup.points.emplace_back(std::cos(angle), std::sin(angle), 0.1 * page);
    soup.triangles.push_back({0, 1, page + 2});
  }
  return soup;
}

TriangleSoup makeBowTie()
{
  TriangleSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 1}, {-1, 1, 1}, {-1, -1, 1}, {1, 0, -1}, {-1, 1, -1}, {-1, -1, -1}};
  soup.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {4, 6, 5}};
  return soup;
}

TriangleSoup makeCubesSharingAnEdge()
{
  TriangleSoup soup = makeCube(glm::dvec3(-1, -1, 0));
  append(soup, makeCube(glm::dvec3(1, 1, 0)));
  return soup;
}

TriangleSoup makeRandomSoup(std::uint32_t triangles, std::uint32_t seed)
{
  std::mt19937 random(seed);
  TriangleSoup soup;
  for (std::uint32_t triangle = 0; triangle < triangles; ++triangle)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      soup.points.push_back(randomPoint(random, 1.0));
    }
    soup.triangles.push_back({3 * triangle, 3 * triangle + 1, 3 * triangle + 2});
  }
  return soup;
}

TriangleSoup makePlates(std::uint32_t plates)
{
  TriangleSoup soup;
  for (std::uint32_t plate = 0; plate < plates; ++plate)
  {
    const double height = plate;
    const std::uint32_t first = 4 * plate;
    for (const glm::dvec2 corner :
         {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)})
    {
      soup.points.emplace_back(corner, height);
    }
    addQuad(soup, first, first + 1, first + 2, first + 3);
  }
  return soup;
}

std::vector<NamedMesh> makeClosedMeshes()
{
  TriangleSoup shell = makeSphere(1.0, 16, 10);
  append(shell, makeSphere(0.5, 12, 8));
  TriangleSoup pair = makeCube(glm::dvec3(-2, 0, 0), 1.5);
  append(pair, makeTorus(0.8, 0.3, 20, 10));
  return {{"cube", makeCube()},
          {"sphere", makeSphere(1.0, 24, 15)},
          {"torus", makeTorus(1.0, 0.4, 32, 16)},
          {"shell", shell},
          {"cube and torus", pair}};
}

std::vector<NamedMesh> makeAllMeshes()
{
  std::vector<NamedMesh> meshes = makeClosedMeshes();
  TriangleSoup duplicates = makeSphere(1.0, 8, 6);
  append(duplicates, makeSphere(1.0, 8, 6));
  TriangleSoup scrambled = makeTorus(1.0, 0.4, 12, 8);
  turnRandomly(scrambled, 5);
  TriangleSoup finned = makeCube();
  append(finned, makeBook(5));
  finned.triangles.push_back({0, 1, 11}); // from an edge of the cube to a page of the book
  meshes.push_back({"open cylinder", makeOpenCylinder(12)});
  meshes.push_back({"moebius strip", makeMoebius(15)});
  meshes.push_back({"book", makeBook(5)});
  meshes.push_back({"bow tie", makeBowTie()});
  meshes.push_back({"cubes sharing an edge", makeCubesSharingAnEdge()});
  meshes.push_back({"random soup", makeRandomSoup(60, 7)});
  meshes.push_back({"plates", makePlates(4)});
  meshes.push_back({"every triangle twice", duplicates});
  meshes.push_back({"scrambled torus", scrambled});
  meshes.push_back({"cube with fins", finned});
  return meshes;
}

SEDGeometry build(const TriangleSoup& soup, const SEDGeometryOptions& options)
{
  std::string error;
  std::optional<SEDGeometry> geometry = buildSEDGeometry(soup, options, error);
  if (!geometry)
  {
    throw std::runtime_error(error);
  }
  return std::move(*geometry);
}

glm::dvec3 randomPoint(std::mt19937& random, double reach)
{
  std::uniform_real_distribution<double> coordinate(-reach, reach);
  const double x = coordinate(random);
  const double y = coordinate(random);
  return {x, y, coordinate(random)};
}

} // namespace shadow::test
