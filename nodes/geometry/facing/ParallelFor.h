#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace shadow
{

/// Calls part(begin, end) for ranges that make up [0, count), in any order and perhaps at once, and returns
/// when all are done. Handed in by whoever has threads; an empty one stands for doing it alone.
using ParallelFor = std::function<void(std::size_t count,
                                       const std::function<void(std::size_t begin, std::size_t end)>& part)>;

/// The same in ranges that begin at multiples of @p grain, and alone where there is but one.
template <typename Part>
void forRanges(const ParallelFor& parallelFor, std::size_t count, std::size_t grain, const Part& part)
{
  if (!parallelFor || count <= grain)
  {
    part(std::size_t{0}, count);
    return;
  }
  parallelFor((count + grain - 1) / grain, [&](std::size_t begin, std::size_t end)
              { part(begin * grain, std::min(end * grain, count)); });
}

} // namespace shadow
