#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <utility>

#include "SEDGeode.h"
#include "SEDGeometryDrawable.h"
#include "ShadowVolumeDrawable.h"

namespace shadow
{

/// The GPU copies of what a scene graph holds, made when first asked for and freed when not asked for any
/// longer.
class DrawableCache
{
public:
  DrawableCache() = default;
  DrawableCache(const DrawableCache&) = delete;
  DrawableCache& operator=(const DrawableCache&) = delete;

  SEDGeometryDrawable& getGeometry(const std::shared_ptr<const SEDGeometry>& geometry);

  /// @param vertices  see ReachableBitsBuffer::upload()
  ReachableBitsBuffer& getReachableBits(const PathState& path, std::size_t vertices);

  /// @param part  which of the light state's volumes
  ShadowVolumeDrawable& getVolume(const PathLightState& light, std::size_t part);

  /// Frees what has not been asked for since the last sweep.
  void sweep();

  /// Frees everything. @pre the context is current, or is gone and @p contextLost
  void release(bool contextLost);

  std::size_t getMemorySize() const;

private:
  struct GeometryEntry
  {
    std::weak_ptr<const SEDGeometry> geometry; ///< guards against another geometry at the same address
    std::unique_ptr<SEDGeometryDrawable> drawable;
    bool used = false; ///< since the last sweep
  };
  std::map<const SEDGeometry*, GeometryEntry> geometries;
  std::map<const PathState*, ReachableBitsBuffer> reachableBits;
  std::map<std::pair<const PathLightState*, std::size_t>, ShadowVolumeDrawable> volumes;
};

} // namespace shadow
