#pragma once

#include <chrono>

namespace shadow
{

/// Wall-clock time since it was made.
class Stopwatch
{
public:
  double getMilliseconds() const
  {
    return std::chrono::duration<double, std::milli>(Clock::now() - this->start).count();
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start = Clock::now();
};

} // namespace shadow
