#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "FaceCounter.h"
#include "SEDGeode.h"
#include "ShadowVolume.h"

namespace shadow
{

/// The GPU copy of a ShadowVolume: indices into the vertices of a SEDGeometryDrawable, and into some of its own
/// for the part close to the light. Has its faces counted.
class ShadowVolumeDrawable
{
public:
  ShadowVolumeDrawable() = default;
  ShadowVolumeDrawable(const ShadowVolumeDrawable&) = delete;
  ShadowVolumeDrawable& operator=(const ShadowVolumeDrawable&) = delete;

  void upload(const ShadowVolume& volume);

  /// Counts the volume's faces.
  /// @param vertexBuffer  of the SEDGeometryDrawable
  /// @pre   the program's uniforms are set
  void draw(const FaceCounter& counter, unsigned int vertexBuffer);

  void release(bool contextLost);
  std::size_t getMemorySize() const { return this->bytes; }

  std::uint64_t revision = 0; ///< what was uploaded last
  bool used = false;          ///< since the cache was swept last

private:
  /// Faces with one way to be counted, in the order of their buffer.
  struct Batch
  {
    std::size_t triangles;
    int multiplicity;
    bool inward; ///< clockwise seen from outside
    bool side;
  };
  using Faces = std::vector<ShadowVolume::Triangle>;

  /// Index lists one behind the other, in a buffer of their own.
  struct Indices
  {
    unsigned int vertexArray = 0;
    unsigned int indexBuffer = 0;
    std::vector<Batch> batches;

    /// @return bytes
    std::size_t upload(const std::vector<std::pair<const Faces*, Batch>>& lists);
    void draw(const FaceCounter& counter, unsigned int vertexBuffer) const;
    void release(bool contextLost);
  };

  Indices whole;
  Indices close; ///< ShadowVolume::close
  unsigned int closeVertexBuffer = 0;
  std::size_t bytes = 0;
};

} // namespace shadow
