#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <vector>

namespace shadow::benchmarks
{

/// The upper one of the two in the middle, where there are two; 0 of none.
inline double median(std::vector<double> values)
{
  if (values.empty())
  {
    return 0.0;
  }
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

} // namespace shadow::benchmarks
