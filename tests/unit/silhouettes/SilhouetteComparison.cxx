#include "SilhouetteComparison.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>

#include <gtest/gtest.h>

namespace shadow::test
{

namespace
{

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

/// What one finder found, to hold others against.
struct Silhouettes
{
  explicit Silhouettes(const SilhouetteFinder& finder, const SEDGeometry& geometry, const LightFacing& facing)
  {
    for (std::size_t index = 0; index < castings.size(); ++index)
    {
      this->edges[index] = finder.find(geometry, facing, castings[index]);
      this->prints[index] = fingerprint(this->edges[index]);
    }
  }

  static constexpr std::array<Casting, 2> castings = {Casting::LightFacing, Casting::EveryTriangle};
  std::array<std::vector<SilhouetteEdge>, 2> edges;
  std::array<std::uint64_t, 2> prints{};
};

bool expectSame(const Silhouettes& expected, const Silhouettes& found, std::size_t finder)
{
  bool same = true;
  for (std::size_t index = 0; index < Silhouettes::castings.size(); ++index)
  {
    if (found.edges[index].size() != expected.edges[index].size() ||
        found.prints[index] != expected.prints[index])
    {
      same = false;
      ADD_FAILURE() << "finder " << finder << ", casting " << index << ": "
                    << describeDifference(sortEdges(expected.edges[index]), sortEdges(found.edges[index]));
    }
  }
  return same;
}

} // namespace

std::vector<SilhouetteMethod> otherMethods()
{
  std::vector<SilhouetteMethod> methods;
  for (const SilhouetteMethod method : getSilhouetteMethods())
  {
    if (method != SilhouetteMethod::BruteForce && !isOnGPU(method))
    {
      methods.push_back(method);
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

bool expectSameEdges(const SEDGeometry& geometry, const LightFacing& facing,
                     const std::vector<std::unique_ptr<SilhouetteFinder>>& finders)
{
  const Silhouettes expected(*finders.front(), geometry, facing);
  bool same = true;
  for (std::size_t index = 1; index < finders.size(); ++index)
  {
    same = expectSame(expected, Silhouettes(*finders[index], geometry, facing), index) && same;
  }
  return same;
}

bool expectSameAnswers(const SEDGeometry& geometry, const glm::dvec4& lightMC,
                       const std::vector<std::unique_ptr<SilhouetteFinder>>& finders)
{
  LightFacing first;
  finders.front()->face(geometry, lightMC, first);
  const Silhouettes expected(*finders.front(), geometry, first);
  LightFacing facing;
  bool same = true;
  for (std::size_t index = 1; index < finders.size(); ++index)
  {
    finders[index]->face(geometry, lightMC, facing);
    if (facing.towards.size() != first.towards.size() ||
        facing.towards.getWords() != first.towards.getWords() ||
        facing.away.getWords() != first.away.getWords())
    {
      same = false;
      ADD_FAILURE() << "finder " << index << " sees triangles face the light differently";
    }
    same = expectSame(expected, Silhouettes(*finders[index], geometry, facing), index) && same;
  }
  return same;
}

} // namespace shadow::test
