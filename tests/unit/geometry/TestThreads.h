#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <numeric>
#include <random>
#include <thread>
#include <vector>

#include "ParallelFor.h"

namespace shadow::test
{

/// Ranges of one, in an order that is another each time, by so many threads.
inline ParallelFor makeThreads(std::size_t threads)
{
  return [threads](std::size_t count, const std::function<void(std::size_t, std::size_t)>& part)
  {
    static std::atomic<unsigned int> calls{0};
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), std::mt19937(++calls));
    std::atomic<std::size_t> next{0};
    std::vector<std::thread> workers;
    for (std::size_t worker = 0; worker < threads; ++worker)
    {
      workers.emplace_back(
          [&]
          {
            for (std::size_t place = next++; place < count; place = next++)
            {
              part(order[place], order[place] + 1);
            }
          });
    }
    std::for_each(workers.begin(), workers.end(), [](std::thread& worker) { worker.join(); });
  };
}

} // namespace shadow::test
