#include "DrawableCache.h"

#include "SweepUnused.h"

namespace shadow
{

SEDGeometryDrawable& DrawableCache::getGeometry(const std::shared_ptr<const SEDGeometry>& geometry)
{
  return *this->geometries.get(
      geometry, [&] { return std::make_unique<SEDGeometryDrawable>(*geometry); },
      [&](SEDGeometryDrawable& drawable) { drawable.update(*geometry); });
}

ReachableBitsBuffer& DrawableCache::getReachableBits(const PathState& path, std::size_t vertices)
{
  ReachableBitsBuffer& buffer = this->reachableBits[&path];
  if (buffer.revision != path.reachableRevision)
  {
    buffer.upload(path.reachableBits, vertices);
    buffer.revision = path.reachableRevision;
  }
  buffer.used = true;
  return buffer;
}

ShadowVolumeDrawable& DrawableCache::getVolume(const PathLightState& light, std::size_t part)
{
  ShadowVolumeDrawable& drawable = this->volumes[{&light, part}];
  if (drawable.revision != light.revision)
  {
    drawable.upload(light.volumes[part]);
    drawable.revision = light.revision;
  }
  drawable.used = true;
  return drawable;
}

void DrawableCache::sweep()
{
  this->geometries.sweep();
  sweepUnused(this->reachableBits, [](ReachableBitsBuffer& buffer) { buffer.release(false); });
  sweepUnused(this->volumes, [](ShadowVolumeDrawable& volume) { volume.release(false); });
}

void DrawableCache::release(bool contextLost)
{
  this->geometries.release(contextLost);
  for (auto& [key, buffer] : this->reachableBits)
  {
    buffer.release(contextLost);
  }
  for (auto& [key, volume] : this->volumes)
  {
    volume.release(contextLost);
  }
  this->reachableBits.clear();
  this->volumes.clear();
}

std::size_t DrawableCache::getMemorySize() const
{
  std::size_t bytes = this->geometries.getMemorySize();
  for (const auto& [key, buffer] : this->reachableBits)
  {
    bytes += buffer.getMemorySize();
  }
  for (const auto& [key, volume] : this->volumes)
  {
    bytes += volume.getMemorySize();
  }
  return bytes;
}

} // namespace shadow
