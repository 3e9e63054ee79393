#pragma once

#include <cstddef>
#include <cstdint>

#include "FaceCounter.h"
#include "SEDGeode.h"
#include "ShadowVolume.h"

namespace shadow
{

/// The GPU copy of a ShadowVolume: indices into the vertices of a SEDGeometryDrawable. Has its faces counted.
class ShadowVolumeDrawable
{
public:
  ShadowVolumeDrawable() = default;
  ShadowVolumeDrawable(const ShadowVolumeDrawable&) = delete;
  ShadowVolumeDrawable& operator=(const ShadowVolumeDrawable&) = delete;

  void upload(const ShadowVolume& volume);

  /// Counts the volume's faces.
  /// @pre   the program's uniforms are set
  void draw(const FaceCounter& counter, unsigned int vertexBuffer);

  void release(bool contextLost);
  std::size_t getMemorySize() const { return this->bytes; }

  std::uint64_t revision = 0; ///< what was uploaded last
  bool used = false;          ///< since the cache was swept last

private:
  unsigned int vertexArray = 0;
  unsigned int indexBuffer = 0;
  // In the order of the buffer:
  std::size_t sides = 0;
  std::size_t doubledSides = 0;
  std::size_t caps = 0; ///< light and dark, counter-clockwise seen from outside
  std::size_t doubledCaps = 0;
  std::size_t reversedCaps = 0;
  std::size_t bytes = 0;
};

} // namespace shadow
