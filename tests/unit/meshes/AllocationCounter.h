#pragma once

#include <cstddef>

namespace shadow::test
{

/// Counts what operator new hands out, in any program that links this in. Meant for one thread at a time.
class AllocationCounter
{
public:
  /// Bytes allocated and not yet freed.
  static std::size_t getCurrent();

  /// The largest getCurrent() since the last resetPeak().
  static std::size_t getPeak();

  static void resetPeak();
};

} // namespace shadow::test
