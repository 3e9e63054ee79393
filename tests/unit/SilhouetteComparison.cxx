#include "SilhouetteComparison.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>

#include <gtest/gtest.h>

#include "TestMeshes.h"

namespace shadow::test
{

namespace
{

constexpr SilhouetteMethod lastMethod = SilhouetteMethod::Hybrid;

using Key = std::array<std::uint32_t, 3>;

std::vector<Key> sortEdges(const std::vector<SilhouetteEdge>& edges)
{
  std::vector<Key> keys;
  keys.reserve(edges.size());
  for (const SilhouetteEdge& edge : edges)
  {
    keys.push_back({edge.from, edge.to, edge.multiplicity});
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

/// Tells multisets apart without sorting them: the sum over all edges of a number that looks random. Two that
/// differ have the same sum with a chance of one in 2^64.
std::uint64_t fingerprint(const std::vector<SilhouetteEdge>& edges)
{
  std::uint64_t sum = 0;
  for (const SilhouetteEdge& edge : edges)
  {
    // SplitMix64's finaliser, twice.
    std::uint64_t bits = std::uint64_t{edge.from} << 32 | edge.to;
    for (const std::uint64_t salt : {std::uint64_t{0x9e3779b97f4a7c15}, std::uint64_t{edge.multiplicity}})
    {
      bits += salt;
      bits = (bits ^ (bits >> 30)) * std::uint64_t{0xbf58476d1ce4e5b9};
      bits = (bits ^ (bits >> 27)) * std::uint64_t{0x94d049bb133111eb};
      bits ^= bits >> 31;
    }
    sum += bits;
  }
  return sum;
}

std::string describeDifference(const std::vector<Key>& expected, const std::vector<Key>& found)
{
  std::vector<Key> missing;
  std::vector<Key> extra;
  std::set_difference(expected.begin(), expected.end(), found.begin(), found.end(),
                      std::back_inserter(missing));
  std::set_difference(found.begin(), found.end(), expected.begin(), expected.end(),
                      std::back_inserter(extra));
  std::ostringstream text;
  text << missing.size() << " edges missing, " << extra.size() << " too many of " << expected.size();
  for (const auto* some : {&missing, &extra})
  {
    if (!some->empty())
    {
      const auto& [from, to, multiplicity] = some->front();
      text << "; " << (some == &missing ? "missing " : "extra ") << from << " -> " << to << " times "
           << multiplicity;
    }
  }
  return text.str();
}

glm::dvec3 randomCorner(const SEDGeometry& geometry, std::mt19937& random)
{
  const auto& triangle = geometry.getTriangles()[random() % geometry.getTriangles().size()];
  return geometry.getPositions()[triangle[random() % 3]];
}

} // namespace

std::vector<SilhouetteMethod> otherMethods()
{
  std::vector<SilhouetteMethod> methods;
  for (int method = 0; method <= static_cast<int>(lastMethod); ++method)
  {
    if (static_cast<SilhouetteMethod>(method) != SilhouetteMethod::BruteForce)
    {
      methods.push_back(static_cast<SilhouetteMethod>(method));
    }
  }
  return methods;
}

std::vector<std::unique_ptr<SilhouetteFinder>> makeAllFinders()
{
  std::vector<std::unique_ptr<SilhouetteFinder>> finders;
  finders.push_back(makeSilhouetteFinder(SilhouetteMethod::BruteForce));
  for (const SilhouetteMethod method : otherMethods())
  {
    finders.push_back(makeSilhouetteFinder(method));
  }
  return finders;
}

LightFacing makeRandomFacing(std::size_t triangles, std::mt19937& random, bool withNeither)
{
  LightFacing facing;
  facing.towards.assign(triangles);
  facing.away.assign(triangles);
  for (std::size_t t = 0; t < triangles; ++t)
  {
    if (!withNeither || random() % 8 != 0)
    {
      (random() & 1u ? facing.towards : facing.away).set(t);
    }
  }
  return facing;
}

glm::dvec4 makeLight(const SEDGeometry& geometry, std::mt19937& random, int kind)
{
  const glm::dvec3 centre = 0.5 * (geometry.getLowerBound() + geometry.getUpperBound());
  const glm::dvec3 half = 0.5 * (geometry.getUpperBound() - geometry.getLowerBound());
  const double size = glm::length(half);
  const auto& triangle = geometry.getTriangles()[random() % geometry.getTriangles().size()];
  const glm::dvec3 a = geometry.getPositions()[triangle[0]];
  const glm::dvec3 b = geometry.getPositions()[triangle[1]];
  const glm::dvec3 c = geometry.getPositions()[triangle[2]];
  switch (kind % 8)
  {
  case 0:
    return {centre + randomPoint(random, 2.0) * size, 1.0};
  case 1:
    return {centre + randomPoint(random, 1.0) * 1e3 * size, 1.0};
  case 2:
    return {randomPoint(random, 1.0), 0.0};
  case 3:
  {
    glm::dvec4 axis(0.0);
    axis[static_cast<int>(random() % 3)] = random() & 1u ? 1.0 : -1.0;
    return axis;
  }
  case 4:
    return {centre + randomPoint(random, 1.0) * half, 1.0};
  case 5:
    return {randomCorner(geometry, random), 1.0};
  case 6:
    return {0.5 * (a + b), 1.0};
  default:
    // Small integers, so that the point is hardly rounded off the plane.
    return {a + static_cast<double>(random() % 9) * (b - a) - static_cast<double>(random() % 9) * (c - a),
            1.0};
  }
}

bool expectSameEdges(const SEDGeometry& geometry, const LightFacing& facing,
                     const std::vector<std::unique_ptr<SilhouetteFinder>>& finders)
{
  bool same = true;
  for (const Casting casting : {Casting::LightFacing, Casting::EveryTriangle})
  {
    const std::vector<SilhouetteEdge> expected = finders.front()->find(geometry, facing, casting);
    const std::uint64_t print = fingerprint(expected);
    for (std::size_t index = 1; index < finders.size(); ++index)
    {
      const std::vector<SilhouetteEdge> found = finders[index]->find(geometry, facing, casting);
      if (found.size() != expected.size() || fingerprint(found) != print)
      {
        same = false;
        ADD_FAILURE() << "finder " << index << ", casting " << static_cast<int>(casting) << ": "
                      << describeDifference(sortEdges(expected), sortEdges(found));
      }
    }
  }
  return same;
}

} // namespace shadow::test
