// How ManifoldSplitter decides which triangles stay together where three or more share an edge.

#include "ManifoldSplitter.h"

#include <algorithm>
#include <cmath>

namespace shadow
{

namespace
{

/// A triangle seen along the edge it hangs on.
struct Spoke
{
  std::uint32_t surface;
  double angle;
  bool upwards;
  std::uint32_t side;
};

/// Falling angle. Triangles at the same angle are duplicates of each other: those that close a bracket come
/// first, so that what is written twice, front and back, becomes two sheets instead of flat pockets; and at
/// all its edges the same one of several copies is the next to be matched.
bool comesBefore(const Spoke& a, const Spoke& b)
{
  if (a.angle != b.angle)
  {
    return a.angle > b.angle;
  }
  if (a.upwards != b.upwards)
  {
    return b.upwards;
  }
  return a.upwards ? a.side > b.side : a.side < b.side;
}

} // namespace

void ManifoldSplitter::pairCrowds()
{
  for (const Crowd& crowd : this->crowds)
  {
    this->pairCrowd(crowd);
  }
}

/// First pairs the sides of each surface among themselves, then those left over.
void ManifoldSplitter::pairCrowd(const Crowd& crowd)
{
  std::vector<Spoke> spokes;
  for (std::size_t index = crowd.begin; index < crowd.end; ++index)
  {
    const Side side = this->sortedSides[index];
    spokes.push_back({this->surfaces[side / 3], this->angleOf(side), this->runsUpwards(side), side});
  }
  std::sort(spokes.begin(), spokes.end(),
            [](const Spoke& a, const Spoke& b)
            { return a.surface != b.surface ? a.surface < b.surface : comesBefore(a, b); });

  std::vector<Side> ring;
  for (std::size_t index = 0; index < spokes.size(); ++index)
  {
    ring.push_back(spokes[index].side);
    if (index + 1 == spokes.size() || spokes[index + 1].surface != spokes[index].surface)
    {
      this->pairEnclosing(ring);
      ring.clear();
    }
  }
  std::sort(spokes.begin(), spokes.end(), comesBefore);
  for (const Spoke& spoke : spokes)
  {
    if (this->partner[spoke.side] == none)
    {
      ring.push_back(spoke.side);
    }
  }
  this->pairEnclosing(ring);
}

/// Matches like brackets, twice around the ring: the sides that run upwards open, the others close. Going
/// round by falling angle, what lies between is on the back of both triangles, so that solids touching in an
/// edge come apart.
///
/// @param ring  unpaired sides of one edge, by falling angle
void ManifoldSplitter::pairEnclosing(const std::vector<Side>& ring)
{
  std::vector<Side> open;
  for (std::size_t step = 0; step < 2 * ring.size(); ++step)
  {
    const Side side = ring[step % ring.size()];
    if (this->runsUpwards(side))
    {
      if (step < ring.size())
      {
        open.push_back(side);
      }
    }
    else if (!open.empty() && this->partner[side] == none)
    {
      this->pair(open.back(), side);
      open.pop_back();
    }
  }
}

/// Angle of a side's triangle around its edge, counter-clockwise about the direction from the lower vertex to
/// the higher one, against a direction that is the same for all triangles of the edge.
double ManifoldSplitter::angleOf(Side side) const
{
  const std::uint32_t corner = this->triangles[side / 3][(side % 3 + 2) % 3];
  const glm::dvec3 low(this->positions[std::min(this->vertexAt(side), this->vertexAfter(side))]);
  const glm::dvec3 high(this->positions[std::max(this->vertexAt(side), this->vertexAfter(side))]);
  const glm::dvec3 axis = (high - low) / glm::length(high - low);
  const glm::dvec3 arm = glm::dvec3(this->positions[corner]) - low;
  const glm::dvec3 helper = std::abs(axis.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 right = glm::cross(axis, helper);
  const glm::dvec3 up = glm::cross(axis, right);
  return std::atan2(glm::dot(arm, up), glm::dot(arm, right));
}

} // namespace shadow
