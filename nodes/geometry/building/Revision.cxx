#include "Revision.h"

#include <atomic>

namespace shadow
{

std::uint64_t nextRevision()
{
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

} // namespace shadow
