#pragma once

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace shadow::truth
{

/// Calls row(y) once for every y in 0..height-1, on all cores. row must not throw.
template <class Row>
void forEachRow(int height, const Row& row)
{
  std::atomic<int> next{0};
  const auto work = [&]
  {
    for (int y = next++; y < height; y = next++)
    {
      row(y);
    }
  };
  std::vector<std::thread> helpers(std::max(1u, std::thread::hardware_concurrency()) - 1);
  for (std::thread& helper : helpers)
  {
    helper = std::thread(work);
  }
  work();
  for (std::thread& helper : helpers)
  {
    helper.join();
  }
}

} // namespace shadow::truth
