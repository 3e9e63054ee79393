#pragma once

#include <cstddef>
#include <functional>

namespace shadow
{

/// Calls part(begin, end) for ranges that make up [0, count), in any order and perhaps at once, and returns
/// when all are done. Handed in by whoever has threads; an empty one stands for doing it alone.
using ParallelFor = std::function<void(std::size_t count,
                                       const std::function<void(std::size_t begin, std::size_t end)>& part)>;

} // namespace shadow
