#pragma once

#include <cstddef>

namespace shadow::test
{

/// Counts the bytes that go to the GL's buffers and to array textures of 32-bit channels while it lives, from
/// whomever. One at a time. @pre a context is current, and the GL's functions are loaded
class UploadCounter
{
public:
  UploadCounter();
  ~UploadCounter();
  UploadCounter(const UploadCounter&) = delete;
  UploadCounter& operator=(const UploadCounter&) = delete;

  std::size_t getBytes() const;
};

} // namespace shadow::test
