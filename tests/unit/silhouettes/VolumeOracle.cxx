#include "VolumeOracle.h"

#include <tuple>

namespace shadow::test
{

namespace
{

constexpr double beyondAllMeshes = 200.0;

/// Of the far copies. Seen from a light close to it, a triangle spans almost half of all directions, and the
/// plane through its far copies passes the light much nearer than they are.
constexpr double farAway = 1e8;

double volumeOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d)
{
  return glm::dot(glm::cross(b - a, c - a), d - a);
}

} // namespace

void EdgeBalance::add(std::uint32_t from, std::uint32_t to, int times)
{
  if (from == to)
  {
    return;
  }
  const bool upwards = from < to;
  const auto key = upwards ? std::pair(from, to) : std::pair(to, from);
  int& sum = this->sums[key];
  sum += upwards ? times : -times;
  if (sum == 0)
  {
    this->sums.erase(key);
  }
}

void EdgeBalance::addTriangle(const std::array<std::uint32_t, 3>& triangle, int times)
{
  this->add(triangle[0], triangle[1], times);
  this->add(triangle[1], triangle[2], times);
  this->add(triangle[2], triangle[0], times);
}

std::vector<std::uint32_t> findFirstAtPosition(const SEDGeometry& geometry)
{
  std::map<std::tuple<float, float, float>, std::uint32_t> firsts;
  std::vector<std::uint32_t> result;
  for (const glm::vec3& position : geometry.getPositions())
  {
    const auto index = static_cast<std::uint32_t>(result.size());
    result.push_back(firsts.emplace(std::tuple(position.x, position.y, position.z), index).first->second);
  }
  return result;
}

namespace
{

/// One number for each vertex of ShadowVolume::close, those of the same copies in the rest of the volume.
std::vector<std::uint32_t> numberCloseVertices(const SEDGeometry& geometry, const ShadowVolume& volume)
{
  using Place = std::tuple<float, float, float, float>;
  std::map<Place, std::uint32_t> known;
  const std::vector<glm::vec3>& positions = geometry.getPositions();
  for (std::uint32_t vertex = 0; vertex < positions.size(); ++vertex)
  {
    const glm::vec3& at = positions[vertex];
    known.emplace(Place(at.x, at.y, at.z, 1.0f), 2 * vertex);
    known.emplace(Place(at.x, at.y, at.z, 0.0f), 2 * vertex + 1);
  }
  std::vector<std::uint32_t> numbers;
  auto next = static_cast<std::uint32_t>(2 * positions.size());
  for (const glm::vec4& vertex : volume.close.vertices)
  {
    const auto entry = known.emplace(Place(vertex.x, vertex.y, vertex.z, vertex.w), next);
    next += entry.second ? 2 : 0;
    numbers.push_back(entry.first->second);
  }
  return numbers;
}

} // namespace

EdgeBalance balanceVolume(const SEDGeometry& geometry, const ShadowVolume& volume, bool directional)
{
  EdgeBalance balance;
  const std::vector<std::uint32_t> first = findFirstAtPosition(geometry);
  const std::vector<std::uint32_t> closeNumbers = numberCloseVertices(geometry, volume);
  const auto add = [&](ShadowVolume::Triangle triangle, int times)
  {
    for (std::uint32_t& vertex : triangle)
    {
      vertex = 2 * first[vertex / 2] + vertex % 2;
      vertex = directional && vertex % 2 == 1 ? 1 : vertex;
    }
    balance.addTriangle(triangle, times);
  };
  const auto addClose = [&](const std::vector<ShadowVolume::Triangle>& faces, int times)
  {
    for (const ShadowVolume::Triangle& face : faces)
    {
      balance.addTriangle({closeNumbers[face[0]], closeNumbers[face[1]], closeNumbers[face[2]]}, times);
    }
  };
  addClose(volume.close.sides, 1);
  addClose(volume.close.doubledSides, 2);
  addClose(volume.close.darkCap, 1);
  for (const auto* faces : {&volume.sides, &volume.lightCap, &volume.darkCap})
  {
    for (const ShadowVolume::Triangle& face : *faces)
    {
      add(face, 1);
    }
  }
  for (const auto* faces : {&volume.doubledSides, &volume.doubledDarkCap})
  {
    for (const ShadowVolume::Triangle& face : *faces)
    {
      add(face, 2);
    }
  }
  for (const ShadowVolume::Triangle& face : volume.lightCapReversed)
  {
    add(face, -1);
  }
  return balance;
}

int crossSegment(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& start, const glm::dvec3& end)
{
  const auto& [a, b, c] = corners;
  const double atStart = volumeOf(a, b, c, start);
  const double atEnd = volumeOf(a, b, c, end);
  if ((atStart > 0.0) == (atEnd > 0.0))
  {
    return 0;
  }
  const bool ab = volumeOf(start, end, a, b) > 0.0;
  const bool bc = volumeOf(start, end, b, c) > 0.0;
  const bool ca = volumeOf(start, end, c, a) > 0.0;
  if (ab != bc || bc != ca)
  {
    return 0;
  }
  return atStart > 0.0 ? 1 : -1;
}

std::array<glm::dvec3, 3> getCorners(const SEDGeometry& geometry, std::size_t triangle)
{
  std::array<std::uint32_t, 3> vertices = geometry.getTriangles()[triangle];
  if (geometry.getReversed().test(triangle))
  {
    std::swap(vertices[1], vertices[2]);
  }
  const std::vector<glm::vec3>& positions = geometry.getPositions();
  return {glm::dvec3(positions[vertices[0]]), glm::dvec3(positions[vertices[1]]),
          glm::dvec3(positions[vertices[2]])};
}

glm::dvec3 getLightEnd(const glm::dvec3& point, const glm::dvec4& lightMC)
{
  return lightMC.w == 0.0 ? point + beyondAllMeshes * glm::normalize(glm::dvec3(lightMC))
                          : glm::dvec3(lightMC);
}

std::size_t countBlockers(const SEDGeometry& geometry, const glm::dvec3& point, const glm::dvec4& lightMC,
                          const LightFacing* onlyTowards)
{
  const glm::dvec3 end = getLightEnd(point, lightMC);
  std::size_t count = 0;
  for (std::size_t triangle = 0; triangle < geometry.getTriangles().size(); ++triangle)
  {
    const std::array<glm::dvec3, 3> corners = getCorners(geometry, triangle);
    // The segment is open: a triangle with a corner at the light only touches it.
    const bool touches = corners[0] == end || corners[1] == end || corners[2] == end;
    if (!touches && (onlyTowards == nullptr || onlyTowards->towards.test(triangle)))
    {
      count += crossSegment(corners, point, end) != 0 ? 1 : 0;
    }
  }
  return count;
}

int countEnclosing(const SEDGeometry& geometry, const ShadowVolume& volume, const glm::dvec4& lightMC,
                   const glm::dvec3& point, const glm::dvec3& outside)
{
  const bool directional = lightMC.w == 0.0;
  const auto place = [&](std::uint32_t index)
  {
    const glm::dvec3 at(geometry.getPositions()[index / 2]);
    const glm::dvec3 along =
        directional ? -glm::normalize(glm::dvec3(lightMC)) : glm::normalize(at - glm::dvec3(lightMC));
    return index % 2 == 0 ? at : at + farAway * along;
  };
  int count = 0;
  const auto cross = [&](const ShadowVolume::Triangle& face) {
    return crossSegment({place(face[0]), place(face[1]), place(face[2])}, outside, point);
  };
  const auto crossSide = [&](const ShadowVolume::Triangle& face) {
    return cross(face) + (directional ? cross({face[0], face[2], face[0] + 1}) : 0);
  };
  const auto placeClose = [&](std::uint32_t index)
  {
    const glm::vec4& vertex = volume.close.vertices[index];
    const glm::dvec3 at(vertex);
    const glm::dvec3 along = vertex.w == 0.0f ? glm::normalize(at - glm::dvec3(lightMC)) : at;
    return vertex.w > 0.0f ? at : (vertex.w < 0.0f ? glm::dvec3(lightMC) : at) + farAway * along;
  };
  const auto crossClose = [&](const std::vector<ShadowVolume::Triangle>& faces, int times)
  {
    for (const ShadowVolume::Triangle& face : faces)
    {
      count += times * crossSegment({placeClose(face[0]), placeClose(face[1]), placeClose(face[2])}, outside, point);
    }
  };
  crossClose(volume.close.sides, 1);
  crossClose(volume.close.doubledSides, 2);
  crossClose(volume.close.darkCap, 1);
  for (const ShadowVolume::Triangle& face : volume.sides)
  {
    count += crossSide(face);
  }
  for (const ShadowVolume::Triangle& face : volume.doubledSides)
  {
    count += 2 * crossSide(face);
  }
  for (const ShadowVolume::Triangle& face : volume.lightCap)
  {
    count += cross(face);
  }
  for (const ShadowVolume::Triangle& face : volume.lightCapReversed)
  {
    count -= cross(face);
  }
  for (const ShadowVolume::Triangle& face : volume.darkCap)
  {
    count += cross(face);
  }
  for (const ShadowVolume::Triangle& face : volume.doubledDarkCap)
  {
    count += 2 * cross(face);
  }
  return count;
}

} // namespace shadow::test
