#include "AllocationCounter.h"

#include <atomic>
#include <cstdlib>
#include <new>

#include <malloc.h>

namespace
{

std::atomic<std::size_t> current{0};
std::atomic<std::size_t> peak{0};

void* allocate(std::size_t size)
{
  void* memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr)
  {
    throw std::bad_alloc();
  }
  const std::size_t used = current += malloc_usable_size(memory);
  if (used > peak)
  {
    peak = used;
  }
  return memory;
}

void release(void* memory) noexcept
{
  if (memory != nullptr)
  {
    current -= malloc_usable_size(memory);
    std::free(memory);
  }
}

} // namespace

void* operator new(std::size_t size)
{
  return allocate(size);
}

void* operator new[](std::size_t size)
{
  return allocate(size);
}

void operator delete(void* memory) noexcept
{
  release(memory);
}

void operator delete[](void* memory) noexcept
{
  release(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
  release(memory);
}

void operator delete[](void* memory, std::size_t) noexcept
{
  release(memory);
}

namespace shadow::test
{

std::size_t AllocationCounter::getCurrent()
{
  return current;
}

std::size_t AllocationCounter::getPeak()
{
  return peak;
}

void AllocationCounter::resetPeak()
{
  peak = current.load();
}

} // namespace shadow::test
