#include "CopiedTriangles.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <unordered_map>

namespace shadow
{

namespace
{

using Corners = std::array<std::uint32_t, 3>;

/// Triangles with the same three corners.
struct Group
{
  Corners corners;
  std::vector<std::uint32_t> members; ///< rising
};

/// The corners, smallest first, whatever the winding.
Corners regardlessOfWinding(const Corners& corners)
{
  return {corners[0], std::min(corners[1], corners[2]), std::max(corners[1], corners[2])};
}

/// Triangles, those with the same smallest corner together, rising within it. A counting sort.
/// @param starts  where the triangles of each corner begin, and where the last ones end
std::vector<std::uint32_t> sortBySmallest(const std::vector<Corners>& triangles, std::size_t vertices,
                                          std::vector<std::uint32_t>& starts)
{
  starts.assign(vertices + 1, 0);
  for (const Corners& corners : triangles)
  {
    ++starts[corners[0] + 1];
  }
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
  std::vector<std::uint32_t> sorted(triangles.size());
  for (std::uint32_t triangle = 0; triangle < triangles.size(); ++triangle)
  {
    sorted[next[triangles[triangle][0]]++] = triangle;
  }
  return sorted;
}

/// Those with more than one member.
std::vector<Group> findGroups(const std::vector<Corners>& triangles, std::size_t vertices)
{
  std::vector<std::uint32_t> starts;
  std::vector<std::uint32_t> sorted = sortBySmallest(triangles, vertices, starts);
  std::vector<Group> groups;
  for (std::size_t vertex = 0; vertex < vertices; ++vertex)
  {
    const auto begin = sorted.begin() + starts[vertex];
    const auto end = sorted.begin() + starts[vertex + 1];
    std::sort(begin, end,
              [&triangles](std::uint32_t a, std::uint32_t b)
              {
                return std::make_tuple(regardlessOfWinding(triangles[a]), a) <
                       std::make_tuple(regardlessOfWinding(triangles[b]), b);
              });
    for (auto first = begin; first != end;)
    {
      const Corners corners = regardlessOfWinding(triangles[*first]);
      const auto last = std::find_if(first, end,
                                     [&](std::uint32_t triangle)
                                     { return regardlessOfWinding(triangles[triangle]) != corners; });
      if (last - first > 1)
      {
        groups.push_back({corners, {first, last}});
      }
      first = last;
    }
  }
  return groups;
}

std::uint64_t edgeBetween(std::uint32_t a, std::uint32_t b)
{
  return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

/// Finds the groups that are walls between solids.
class WallFinder
{
public:
  WallFinder(const std::vector<Corners>& triangles, const std::vector<Group>& theGroups)
      : groups(theGroups), parents(theGroups.size()), mayBeWall(theGroups.size(), 1),
        ends(theGroups.size(), 0)
  {
    std::iota(this->parents.begin(), this->parents.end(), std::uint32_t{0});
    this->joinGroups();
    this->countOthers(triangles);
    this->judge();
  }

  bool isWall(std::uint32_t group)
  {
    const std::uint32_t root = this->find(group);
    return this->mayBeWall[root] != 0 && this->ends[root] != 0;
  }

private:
  struct Meeting
  {
    std::uint32_t group;          ///< one that has the edge
    std::uint32_t groupCount = 0; ///< how many have it
    std::uint32_t sides = 0;      ///< of all triangles, those of the groups included
  };

  std::uint32_t find(std::uint32_t group)
  {
    for (; this->parents[group] != group; group = this->parents[group])
    {
      this->parents[group] = this->parents[this->parents[group]];
    }
    return group;
  }

  void joinGroups()
  {
    for (std::uint32_t group = 0; group < this->groups.size(); ++group)
    {
      for (std::size_t side = 0; side < 3; ++side)
      {
        const Corners& corners = this->groups[group].corners;
        Meeting& meeting = this->meetings.try_emplace(edgeBetween(corners[side], corners[(side + 1) % 3]),
                                                      Meeting{group})
                               .first->second;
        ++meeting.groupCount;
        this->parents[this->find(group)] = this->find(meeting.group);
      }
    }
  }

  void countOthers(const std::vector<Corners>& triangles)
  {
    for (const Corners& corners : triangles)
    {
      for (std::size_t side = 0; side < 3; ++side)
      {
        const auto meeting = this->meetings.find(edgeBetween(corners[side], corners[(side + 1) % 3]));
        if (meeting != this->meetings.end())
        {
          ++meeting->second.sides;
        }
      }
    }
  }

  void judge()
  {
    for (std::uint32_t group = 0; group < this->groups.size(); ++group)
    {
      this->mayBeWall[this->find(group)] &= this->groups[group].members.size() == 2 ? 1 : 0;
    }
    for (const auto& [edge, meeting] : this->meetings)
    {
      if (meeting.groupCount == 1)
      {
        const std::uint32_t root = this->find(meeting.group);
        const std::size_t others = meeting.sides - this->groups[meeting.group].members.size();
        this->ends[root] = 1;
        this->mayBeWall[root] &= others >= 2 ? 1 : 0;
      }
    }
  }

  const std::vector<Group>& groups;
  std::vector<std::uint32_t> parents; ///< of a forest of connected groups
  std::vector<std::uint8_t> mayBeWall; ///< of a root: each member is there twice, and others meet each end
  std::vector<std::uint8_t> ends;      ///< of a root: there is one
  std::unordered_map<std::uint64_t, Meeting> meetings; ///< by edge, those of groups only
};

} // namespace

std::vector<std::uint8_t> findCopies(const std::vector<Corners>& triangles, std::size_t vertices)
{
  const std::vector<Group> groups = findGroups(triangles, vertices);
  std::vector<std::uint8_t> copies;
  if (groups.empty())
  {
    return copies;
  }
  WallFinder walls(triangles, groups);
  for (std::uint32_t group = 0; group < groups.size(); ++group)
  {
    if (!walls.isWall(group))
    {
      copies.resize(triangles.size(), 0);
      const std::vector<std::uint32_t>& members = groups[group].members;
      std::for_each(members.begin() + 1, members.end(),
                    [&copies](std::uint32_t member) { copies[member] = 1; });
    }
  }
  return copies;
}

FacingBits setCopiesApart(const std::vector<std::uint8_t>& copies, const std::vector<std::uint32_t>& order,
                          std::vector<Corners>& triangles, std::vector<glm::vec3>& positions)
{
  FacingBits apart(triangles.size());
  for (std::size_t place = 0; !copies.empty() && place < triangles.size(); ++place)
  {
    if (copies[order[place]] != 0)
    {
      apart.set(place);
      for (std::uint32_t& corner : triangles[place])
      {
        positions.push_back(glm::vec3(positions[corner]));
        corner = static_cast<std::uint32_t>(positions.size() - 1);
      }
    }
  }
  return apart;
}

} // namespace shadow
