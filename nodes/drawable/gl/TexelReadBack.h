#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkOpenGLState;

namespace shadow
{

class TexelArray;

/// What reading texels back cost, in milliseconds on the wall clock.
struct ReadBackTimes
{
  double start = 0.0; ///< asking for the copy into the pixel buffer; on a software GL the copy itself
  double wait = 0.0;  ///< for the GPU: whatever it had to do before, and the copy
  double copy = 0.0;  ///< from the pixel buffer into memory

  double getSum() const { return this->start + this->wait + this->copy; }
};

/// Copies a TexelArray to main memory through a pixel buffer, so that both processors go on working between
/// start() and fetch().
class TexelReadBack
{
public:
  TexelReadBack() = default;
  TexelReadBack(const TexelReadBack&) = delete;
  TexelReadBack& operator=(const TexelReadBack&) = delete;

  /// Asks the GL for a copy of all texels as they are now. A copy not fetched yet is forgotten.
  void start(vtkOpenGLState* state, const TexelArray& texels);

  bool isStarted() const { return this->fence != nullptr; }

  /// Whether fetch() would not have to wait. @pre isStarted()
  bool isReady() const;

  /// Waits for the copy.
  ///
  /// @param words  32-bit words of all channels of all texels, by index
  /// @return false when no copy was started, or the GL lost it
  bool fetch(std::vector<std::uint32_t>& words);

  const ReadBackTimes& getTimes() const { return this->times; } ///< of the last copy

  /// Frees the GL objects. @pre their context is current, or is gone and @p contextLost
  void release(bool contextLost = false);

  std::size_t getMemorySize() const { return this->capacity; }

private:
  void dropFence();

  unsigned int framebuffer = 0;
  unsigned int buffer = 0;
  std::size_t capacity = 0; ///< bytes of the buffer
  std::size_t bytes = 0;    ///< of the copy
  void* fence = nullptr;    ///< a GLsync, which is not named here to keep the GL out of headers
  ReadBackTimes times;
};

} // namespace shadow
