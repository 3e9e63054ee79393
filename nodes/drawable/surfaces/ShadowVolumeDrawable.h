#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "FaceCounter.h"
#include "SEDGeode.h"
#include "ShadowVolume.h"
#include "VolumeFaces.h"

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
  struct Faces
  {
    const std::vector<ShadowVolume::Triangle>* triangles;
    FaceKind kind;
  };
  /// The same as they lie in a buffer, one behind the other.
  struct Batch
  {
    std::size_t triangles;
    FaceKind kind;
  };

  /// Index lists in a buffer of their own.
  struct Indices
  {
    unsigned int vertexArray = 0;
    unsigned int indexBuffer = 0;
    std::vector<Batch> batches;

    /// @return bytes
    std::size_t upload(const std::vector<Faces>& lists);
    void draw(const FaceCounter& counter, unsigned int vertexBuffer) const;
    void release(bool contextLost);
  };

  template <class Owner, std::size_t count>
  static std::vector<Faces> listFaces(const Owner& owner, const std::array<FacesOf<Owner>, count>& kinds);

  Indices whole;
  Indices close; ///< ShadowVolume::close
  unsigned int closeVertexBuffer = 0;
  std::size_t bytes = 0;
};

} // namespace shadow
