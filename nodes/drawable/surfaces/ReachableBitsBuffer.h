#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

namespace shadow
{

/// What each side of a path's triangles faces, as a vertex attribute of the pre-pass.
class ReachableBitsBuffer
{
public:
  ReachableBitsBuffer() = default;
  ReachableBitsBuffer(const ReachableBitsBuffer&) = delete;
  ReachableBitsBuffer& operator=(const ReachableBitsBuffer&) = delete;

  /// @param bits      a triangle, see PathState::reachableBits
  /// @param vertices  of the SEDGeometryDrawable; those beyond the triangles' own are never looked at, but
  /// are fetched
  void upload(const std::vector<glm::uvec2>& bits, std::size_t vertices);

  unsigned int getBuffer() const { return this->buffer; }
  void release(bool contextLost);
  std::size_t getMemorySize() const { return this->bytes; }

  std::uint64_t revision = 0; ///< what was uploaded last
  bool used = false;          ///< since the cache was swept last

private:
  unsigned int buffer = 0;
  std::size_t bytes = 0;
};

} // namespace shadow
