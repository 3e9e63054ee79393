#include "MemoryCap.h"

#include <algorithm>
#include <fstream>

#include <unistd.h>

namespace shadow::examples
{

namespace
{

constexpr std::uintmax_t gigabyte = std::uintmax_t{1} << 30;
constexpr std::uintmax_t mostTimesFile = 256;

/// Of this process; 0 where the system does not tell.
std::uintmax_t getAddressSpace()
{
  std::uintmax_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uintmax_t>(sysconf(_SC_PAGESIZE));
}

} // namespace

MemoryCap::MemoryCap(std::uintmax_t fileSize)
{
  const std::uintmax_t taken = getAddressSpace();
  const auto machine = static_cast<std::uintmax_t>(sysconf(_SC_PHYS_PAGES)) *
                       static_cast<std::uintmax_t>(sysconf(_SC_PAGESIZE));
  const std::uintmax_t more = std::min(gigabyte + mostTimesFile * fileSize, std::max(machine, gigabyte));
  if (taken == 0 || getrlimit(RLIMIT_AS, &this->before) != 0)
  {
    return;
  }
  rlimit capped = this->before;
  capped.rlim_cur = static_cast<rlim_t>(std::min<std::uintmax_t>(taken + more, this->before.rlim_cur));
  this->set = setrlimit(RLIMIT_AS, &capped) == 0;
}

MemoryCap::~MemoryCap()
{
  if (this->set)
  {
    setrlimit(RLIMIT_AS, &this->before);
  }
}

} // namespace shadow::examples
