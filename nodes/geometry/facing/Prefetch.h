#pragma once

#include <cstddef>

namespace shadow
{

/// Has the processor fetch memory that will be read soon. For reads at scattered places, which it cannot
/// foresee.
inline void prefetch(const void* address, std::size_t bytes)
{
#ifdef __GNUC__
  constexpr std::size_t line = 64;
  for (std::size_t offset = 0; offset < bytes; offset += line)
  {
    __builtin_prefetch(static_cast<const char*>(address) + offset);
  }
#else
  static_cast<void>(address);
  static_cast<void>(bytes);
#endif
}

} // namespace shadow
