#include "DrawableCache.h"

namespace shadow
{

namespace
{

template <class Map, class Get>
void sweepMap(Map& map, Get&& get)
{
  for (auto entry = map.begin(); entry != map.end();)
  {
    auto& drawable = get(entry->second);
    if (drawable.used)
    {
      drawable.used = false;
      ++entry;
    }
    else
    {
      drawable.release(false);
      entry = map.erase(entry);
    }
  }
}

} // namespace

SEDGeometryDrawable& DrawableCache::getGeometry(const std::shared_ptr<const SEDGeometry>& geometry)
{
  GeometryEntry& entry = this->geometries[geometry.get()];
  if (entry.drawable == nullptr || entry.geometry.lock() != geometry)
  {
    if (entry.drawable != nullptr)
    {
      entry.drawable->release(false);
    }
    entry.drawable = std::make_unique<SEDGeometryDrawable>(*geometry);
    entry.geometry = geometry;
  }
  entry.drawable->used = true;
  return *entry.drawable;
}

ReachableBitsTexture& DrawableCache::getReachableBits(const PathState& path, std::size_t maximumTexels)
{
  ReachableBitsTexture& texture = this->reachableBits[&path];
  if (texture.revision != path.reachableRevision)
  {
    texture.upload(path.reachableBits, maximumTexels);
    texture.revision = path.reachableRevision;
  }
  texture.used = true;
  return texture;
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
  sweepMap(this->geometries, [](GeometryEntry& entry) -> SEDGeometryDrawable& { return *entry.drawable; });
  sweepMap(this->reachableBits, [](ReachableBitsTexture& texture) -> ReachableBitsTexture& { return texture; });
  sweepMap(this->volumes, [](ShadowVolumeDrawable& volume) -> ShadowVolumeDrawable& { return volume; });
}

void DrawableCache::release(bool contextLost)
{
  for (auto& [key, entry] : this->geometries)
  {
    entry.drawable->release(contextLost);
  }
  for (auto& [key, texture] : this->reachableBits)
  {
    texture.release(contextLost);
  }
  for (auto& [key, volume] : this->volumes)
  {
    volume.release(contextLost);
  }
  this->geometries.clear();
  this->reachableBits.clear();
  this->volumes.clear();
}

std::size_t DrawableCache::getMemorySize() const
{
  std::size_t bytes = 0;
  for (const auto& [key, entry] : this->geometries)
  {
    bytes += entry.drawable->getMemorySize();
  }
  for (const auto& [key, texture] : this->reachableBits)
  {
    bytes += texture.getMemorySize();
  }
  for (const auto& [key, volume] : this->volumes)
  {
    bytes += volume.getMemorySize();
  }
  return bytes;
}

} // namespace shadow
