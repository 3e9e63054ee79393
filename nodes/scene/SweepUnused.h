#pragma once

#include <iterator>

namespace shadow
{

/// Erases a map's entries whose values have not been marked as used since the last sweep, and takes the marks
/// off the others.
///
/// @param drop  called with each value before it is erased
template <class Map, class Drop>
void sweepUnused(Map& map, Drop&& drop)
{
  for (auto entry = map.begin(); entry != map.end();)
  {
    if (entry->second.used)
    {
      entry->second.used = false;
      ++entry;
    }
    else
    {
      drop(entry->second);
      entry = map.erase(entry);
    }
  }
}

template <class Map>
void sweepUnused(Map& map)
{
  sweepUnused(map, [](auto&) {});
}

} // namespace shadow
