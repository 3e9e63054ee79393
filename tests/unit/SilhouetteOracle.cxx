#include "SilhouetteOracle.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <random>
#include <sstream>

#include "ExactSign.h"

namespace shadow::test
{

std::vector<glm::dvec4> makeLights(const SEDGeometry& geometry, std::size_t count, std::uint32_t seed)
{
  std::mt19937 random(seed);
  const glm::dvec3 centre = 0.5 * (geometry.getLowerBound() + geometry.getUpperBound());
  const double size = glm::length(geometry.getUpperBound() - geometry.getLowerBound());
  std::vector<glm::dvec4> lights;
  for (std::size_t index = 0; index < count; ++index)
  {
    const std::size_t triangle = random() % geometry.getTriangles().size();
    const auto [a, b, c] = getCorners(geometry, triangle);
    const glm::dvec3 somewhere = randomPoint(random, 1.0);
    switch (index % 8)
    {
    case 0: // around the mesh
      lights.emplace_back(centre + 2.0 * size * somewhere, 1.0);
      break;
    case 1:
      lights.emplace_back(somewhere, 0.0);
      break;
    case 2: // far away
      lights.emplace_back(centre + 1e6 * size * somewhere, 1.0);
      break;
    case 3: // close to the surface
      lights.emplace_back(a + 1e-2 * size * somewhere, 1.0);
      break;
    case 4: // at a vertex, in single precision and exactly
      lights.emplace_back(index % 16 == 4 ? a : a * (1.0 + 1e-12), 1.0);
      break;
    case 5: // in a plane, as far as rounding lets it
      lights.emplace_back(a + 3.0 * somewhere.x * (b - a) + 3.0 * somewhere.y * (c - a), 1.0);
      break;
    case 6: // along a triangle
      lights.emplace_back(index % 16 == 6 ? b - a : (b - a) + somewhere.x * (c - a), 0.0);
      break;
    default: // within the box, often inside the mesh
      lights.emplace_back(centre + 0.5 * (geometry.getUpperBound() - geometry.getLowerBound()) * somewhere,
                          1.0);
      break;
    }
  }
  return lights;
}

LightFacing faceExactly(const SEDGeometry& geometry, const glm::dvec4& light)
{
  const std::vector<glm::vec3>& p = geometry.getPositions();
  LightFacing facing;
  facing.towards.assign(geometry.getTriangles().size());
  facing.away.assign(geometry.getTriangles().size());
  for (std::size_t t = 0; t < geometry.getTriangles().size(); ++t)
  {
    const std::array<std::uint32_t, 3>& corners = geometry.getTriangles()[t];
    const bool touches =
        light.w != 0.0 && std::any_of(corners.begin(), corners.end(),
                                      [&](std::uint32_t v) { return p[v] == glm::vec3(light); });
    const int raster = touches ? 0 : exactSign(p[corners[0]], p[corners[1]], p[corners[2]], light);
    if (raster != 0)
    {
      ((raster > 0) != geometry.getReversed().test(t) ? facing.towards : facing.away).set(t);
    }
  }
  return facing;
}

EdgeBalance sumSides(const SEDGeometry& geometry, const LightFacing& facing, Casting casting)
{
  EdgeBalance sums;
  for (std::size_t t = 0; t < geometry.getTriangles().size(); ++t)
  {
    const bool away = casting == Casting::EveryTriangle && facing.away.test(t);
    if (facing.towards.test(t) || away)
    {
      sums.addTriangle(geometry.getTriangles()[t], away != geometry.getReversed().test(t) ? -1 : 1);
    }
  }
  return sums;
}

EdgeBalance sumSilhouette(const std::vector<SilhouetteEdge>& silhouette)
{
  EdgeBalance sums;
  for (const SilhouetteEdge& edge : silhouette)
  {
    sums.add(edge.from, edge.to, static_cast<int>(edge.multiplicity));
  }
  return sums;
}

bool areSame(const std::vector<SilhouetteEdge>& left, const std::vector<SilhouetteEdge>& right)
{
  using Key = std::array<std::uint32_t, 3>;
  const auto toKeys = [](const std::vector<SilhouetteEdge>& edges)
  {
    std::vector<Key> keys;
    for (const SilhouetteEdge& edge : edges)
    {
      keys.push_back({edge.from, edge.to, edge.multiplicity});
    }
    return keys;
  };
  std::vector<Key> first = toKeys(left);
  std::vector<Key> second = toKeys(right);
  if (first != second)
  {
    std::sort(first.begin(), first.end());
    std::sort(second.begin(), second.end());
  }
  return first == second;
}

TriangleSoup readObj(const std::filesystem::path& file)
{
  TriangleSoup soup;
  std::ifstream input(file);
  for (std::string line; std::getline(input, line);)
  {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v")
    {
      glm::dvec3 point;
      words >> point.x >> point.y >> point.z;
      soup.points.push_back(point);
    }
    else if (word == "f")
    {
      std::vector<std::uint32_t> corners;
      while (words >> word)
      {
        corners.push_back(static_cast<std::uint32_t>(std::stoul(word)) - 1);
      }
      for (std::size_t corner = 2; corner < corners.size(); ++corner)
      {
        soup.triangles.push_back({corners[0], corners[corner - 1], corners[corner]});
      }
    }
  }
  return soup;
}

std::vector<NamedMesh> findSharedMeshes()
{
  std::vector<NamedMesh> meshes;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(SHADOW_MODELS, error))
  {
    if (entry.path().extension() == ".obj")
    {
      meshes.push_back({entry.path().stem().string(), readObj(entry.path())});
    }
  }
  return meshes;
}

} // namespace shadow::test
