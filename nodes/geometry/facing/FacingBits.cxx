#include "FacingBits.h"

#include <bitset>

namespace shadow
{

std::size_t FacingBits::countSet() const
{
  std::size_t set = 0;
  for (const std::uint64_t word : this->words)
  {
    set += std::bitset<64>(word).count();
  }
  return set;
}

} // namespace shadow
