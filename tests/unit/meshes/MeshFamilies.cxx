#include "MeshFamilies.h"

#include <cmath>
#include <cstdint>

namespace shadow::test
{

namespace
{

/// Large enough for several levels of clusters.
TriangleSoup makeDentedSphere()
{
  TriangleSoup soup = makeSphere(1.0, 120, 100);
  for (glm::dvec3& point : soup.points)
  {
    point *= 1.0 + 0.03 * std::sin(17.0 * point.x) * std::sin(13.0 * point.y) * std::sin(11.0 * point.z);
  }
  return soup;
}

} // namespace

TriangleSoup makeGridSoup(std::mt19937& random)
{
  const std::uint32_t side = 2 + random() % 3;
  TriangleSoup soup;
  for (std::uint32_t point = 0; point < side * side * side; ++point)
  {
    soup.points.emplace_back(point % side, point / side % side, point / (side * side));
  }
  const std::size_t wanted = 1 + random() % 80;
  const auto count = static_cast<std::uint32_t>(soup.points.size());
  while (soup.triangles.size() < wanted)
  {
    const std::uint32_t a = random() % count;
    // Mostly neighbours on the grid, so that edges are shared.
    const std::uint32_t b = random() % 4 == 0 ? random() % count : (a + 1 + random() % side) % count;
    const std::uint32_t c = random() % 4 == 0 ? random() % count : (a + side * (1 + random() % side)) % count;
    if (a != b && b != c && c != a)
    {
      soup.triangles.push_back({a, b, c});
    }
  }
  return soup;
}

TriangleSoup makeCrowdedSoup(std::mt19937& random)
{
  const std::uint32_t points = 4 + random() % 60;
  const std::uint32_t triangles = 1 + random() % 300;
  const bool whole = random() % 2 == 0;
  const double scale = std::pow(10.0, static_cast<int>(random() % 16) - 6);
  const double squeeze = random() % 3 == 0 ? 1e-5 : 1.0;
  TriangleSoup soup;
  for (std::uint32_t point = 0; point < points; ++point)
  {
    const glm::dvec3 place = randomPoint(random, 4.0) * glm::dvec3(1.0, squeeze, 1.0);
    soup.points.push_back(whole ? glm::round(place) : scale * place);
  }
  const auto pick = [&random, points] { return static_cast<std::uint32_t>(random() % points); };
  for (std::uint32_t triangle = 0; triangle < triangles; ++triangle)
  {
    soup.triangles.push_back({pick(), pick(), pick()});
  }
  return soup;
}

std::vector<NamedMesh> makeLargeMeshes()
{
  TriangleSoup halfOpen = makeTorus(1.0, 0.4, 80, 40);
  halfOpen.triangles.resize(halfOpen.triangles.size() * 3 / 5);
  TriangleSoup twice = makeSphere(1.0, 40, 30);
  append(twice, makeSphere(1.0, 40, 30));
  return {{"fine torus", makeTorus(1.0, 0.4, 100, 50)},
          {"dented sphere", makeDentedSphere()},
          {"open torus", halfOpen},
          {"many plates", makePlates(300)},
          {"large soup", makeRandomSoup(3000, 3)},
          {"fine sphere twice", twice}};
}

} // namespace shadow::test
