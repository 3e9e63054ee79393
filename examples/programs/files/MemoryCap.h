#ifndef shadow_examples_MemoryCap_h
#define shadow_examples_MemoryCap_h

#include <cstdint>

#include <sys/resource.h>

namespace shadow::examples
{

/// Keeps a reader from taking more memory than a file of this size can ask for: a damaged number in a small file
/// asks for all there is, and the machine stands still long before it is refused.
///
/// While a cap lives the process may grow by a gigabyte and 256 times the file, but by no more than the machine's
/// memory. What goes beyond throws std::bad_alloc.
class MemoryCap
{
public:
  explicit MemoryCap(std::uintmax_t fileSize);
  ~MemoryCap();
  MemoryCap(const MemoryCap&) = delete;
  MemoryCap& operator=(const MemoryCap&) = delete;

private:
  rlimit before{};
  bool set = false;
};

} // namespace shadow::examples

#endif
