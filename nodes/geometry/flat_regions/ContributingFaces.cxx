#include "ContributingFaces.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace shadow
{

namespace
{

/// Adds a face above all others.
void add(std::vector<FaceRun>& runs, std::uint32_t face)
{
  if (runs.empty() || face != runs.back().first + runs.back().count)
  {
    runs.push_back({face, 0});
  }
  ++runs.back().count;
}

bool isIdle(const SEDGeometry& geometry, const TopologyAwareMesh& mesh, std::size_t face)
{
  constexpr std::array<std::size_t, 3> edges = {0, 1, 2};
  return std::all_of(edges.begin(), edges.end(),
                     [&](std::size_t edge) { return mesh.getFate(geometry, face, edge) == EdgeFate::Never; });
}

double findLongestSquare(const SEDGeometry& geometry, std::size_t face)
{
  return std::max({geometry.getSquaredLength(face, 0), geometry.getSquaredLength(face, 1),
                   geometry.getSquaredLength(face, 2)});
}

} // namespace

std::size_t countFaces(const std::vector<FaceRun>& runs)
{
  return std::accumulate(runs.begin(), runs.end(), std::size_t{0},
                         [](std::size_t faces, const FaceRun& run) { return faces + run.count; });
}

ContributingFaces::ContributingFaces(const SEDGeometry& geometry, const TopologyAwareMesh& mesh)
{
  for (std::uint32_t face = 0; face < mesh.countFaces(); ++face)
  {
    if (!isIdle(geometry, mesh, face))
    {
      add(this->runs, face);
    }
  }
}

std::vector<FaceRun> ContributingFaces::findLongFrom(const SEDGeometry& geometry, double length) const
{
  std::vector<FaceRun> found;
  for (const FaceRun& run : this->runs)
  {
    for (std::uint32_t face = run.first; face < run.first + run.count; ++face)
    {
      if (findLongestSquare(geometry, face) >= length * length)
      {
        add(found, face);
      }
    }
  }
  return found;
}

} // namespace shadow
