#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <vector>

namespace shadow::bench
{

/// @pre  not empty
inline double median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

/// Milliseconds that a call takes.
template <typename Call>
double measure(const Call& call)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  call();
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Milliseconds that a call keeps the processor busy, on the calling thread. What else runs on the machine
/// takes caches from it, but no time.
template <typename Call>
double measureThread(const Call& call)
{
  const auto now = []
  {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
  };
  const double start = now();
  call();
  return now() - start;
}

} // namespace shadow::bench
