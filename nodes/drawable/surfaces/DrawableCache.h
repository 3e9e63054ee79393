#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <utility>

#include "KeptByMesh.h"
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

  /// Of a mesh that has moved positions only are copied, and what else depends on them.
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
  KeptByMesh<SEDGeometryDrawable> geometries;
  std::map<const PathState*, ReachableBitsBuffer> reachableBits;
  std::map<std::pair<const PathLightState*, std::size_t>, ShadowVolumeDrawable> volumes;
};

} // namespace shadow
