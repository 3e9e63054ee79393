#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>

#include "SEDGeometry.h"
#include "SweepUnused.h"

namespace shadow
{

/// What is kept on the GPU for each geometry of a scene. Where a geometry takes the place of another that it
/// is, moved, what was kept for that one is handed on and brought up to date.
///
/// @tparam Kept  with methods release(bool contextLost) and getMemorySize()
template <class Kept>
class KeptByMesh
{
public:
  /// What is kept for the geometry.
  ///
  /// @param make    makes it as a std::unique_ptr, which may be empty: then there is nothing to keep
  /// @param update  brings what was made for the geometry before it moved up to date
  /// @return nullptr when there is nothing to keep
  /// @par Cost  O(log(geometries)); O(geometries) for a new one
  template <class Make, class Update>
  Kept* get(const std::shared_ptr<const SEDGeometry>& geometry, Make&& make, Update&& update)
  {
    const auto place = this->entries.try_emplace(geometry.get()).first;
    Entry& entry = place->second;
    if (entry.kept == nullptr || entry.geometry.lock() != geometry)
    {
      std::unique_ptr<Kept> kept = this->takeMoved(geometry->getTopology());
      if (entry.kept != nullptr)
      {
        entry.kept->release(false);
      }
      if (kept != nullptr)
      {
        update(*kept);
      }
      else
      {
        kept = make();
      }
      entry.kept = std::move(kept);
      entry.geometry = geometry;
      entry.topology = geometry->getTopology();
    }
    if (entry.kept == nullptr)
    {
      this->entries.erase(place);
      return nullptr;
    }
    entry.used = true;
    return entry.kept.get();
  }

  /// @pre get() has returned something since the last sweep
  Kept& at(const SEDGeometry& geometry) { return *this->entries.at(&geometry).kept; }

  /// Frees what has not been asked for since the last sweep.
  void sweep()
  {
    sweepUnused(this->entries,
                [](Entry& entry)
                {
                  if (entry.kept != nullptr)
                  {
                    entry.kept->release(false);
                  }
                });
  }

  /// Frees everything. @pre the context is current, or is gone and @p contextLost
  void release(bool contextLost)
  {
    for (auto& [key, entry] : this->entries)
    {
      if (entry.kept != nullptr)
      {
        entry.kept->release(contextLost);
      }
    }
    this->entries.clear();
  }

  std::size_t getMemorySize() const
  {
    std::size_t bytes = 0;
    for (const auto& [key, entry] : this->entries)
    {
      bytes += entry.kept != nullptr ? entry.kept->getMemorySize() : 0;
    }
    return bytes;
  }

private:
  struct Entry
  {
    std::weak_ptr<const SEDGeometry> geometry; ///< guards against another geometry at the same address
    std::uint64_t topology = 0;
    std::unique_ptr<Kept> kept; ///< none once it was handed on
    bool used = false;          ///< since the last sweep
  };

  /// What nobody has asked for since the last sweep, best of a geometry that is gone. Should somebody still
  /// ask for it, it is made anew.
  std::unique_ptr<Kept> takeMoved(std::uint64_t topology)
  {
    Entry* found = nullptr;
    for (auto& [key, entry] : this->entries)
    {
      if (!entry.used && entry.kept != nullptr && entry.topology == topology &&
          (found == nullptr || entry.geometry.expired()))
      {
        found = &entry;
      }
    }
    return found != nullptr ? std::move(found->kept) : nullptr;
  }

  std::map<const SEDGeometry*, Entry> entries;
};

} // namespace shadow
