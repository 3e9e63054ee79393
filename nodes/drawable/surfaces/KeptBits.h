#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace shadow
{

/// Bits of a shadow mask that are those of the mask before it.
struct KeptBits
{
  std::uint32_t inPlace = 0;
  std::vector<std::pair<int, int>> moved; ///< the bit's number before, and now

  bool isEmpty() const { return this->inPlace == 0 && this->moved.empty(); }

  /// The number that a bit had in the mask before; nothing when it is not kept.
  std::optional<int> findBefore(int bit) const
  {
    const auto move = std::find_if(this->moved.begin(), this->moved.end(),
                                   [bit](const std::pair<int, int>& each) { return each.second == bit; });
    if (move != this->moved.end())
    {
      return move->first;
    }
    return ((this->inPlace >> static_cast<unsigned>(bit)) & 1u) != 0 ? std::optional<int>(bit) : std::nullopt;
  }
};

} // namespace shadow
