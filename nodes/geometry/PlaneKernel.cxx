#include "PlaneKernel.h"

#include <cstring>

// Vectors of GCC and Clang, and little-endian words: byte i of a word holds bits 8 i to 8 i + 7.
#if defined(__GNUC__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
#define SHADOW_HAS_VECTORS
#if defined(__x86_64__)
#define SHADOW_HAS_AVX2
#endif
#endif

namespace shadow
{

namespace
{

void compareScalar(const PlaneBlock* blocks, std::size_t count, const ScaledLight& light,
                   std::uint64_t* towards, std::uint64_t* away)
{
  for (std::size_t index = 0; index < count; ++index)
  {
    const PlaneBlock& block = blocks[index];
    std::uint64_t above = 0;
    std::uint64_t below = 0;
    for (std::size_t bit = 0; bit < PlaneBlock::triangles; ++bit)
    {
      const std::size_t slot = PlaneBlock::slotOf(bit);
      const float value = (block.x[slot] * light.x + block.y[slot] * light.y) +
                          (block.z[slot] * light.z + block.offset[slot] * light.w);
      above |= std::uint64_t{value > light.bound} << bit;
      below |= std::uint64_t{value < -light.bound} << bit;
    }
    towards[index] = above;
    away[index] = below;
  }
}

#ifdef SHADOW_HAS_VECTORS

using Floats = float __attribute__((vector_size(32)));
using Masks = std::int32_t __attribute__((vector_size(32)));
using Bytes = std::uint8_t __attribute__((vector_size(8)));

/// Always inlined, so that it is compiled for whatever its caller is compiled for.
__attribute__((always_inline)) inline void compareVectors(const PlaneBlock* blocks, std::size_t count,
                                                          const ScaledLight& light, std::uint64_t* towards,
                                                          std::uint64_t* away)
{
  for (std::size_t index = 0; index < count; ++index)
  {
    const PlaneBlock& block = blocks[index];
    Masks above{};
    Masks below{};
    for (std::size_t bit = 0; bit < 8; ++bit)
    {
      Floats x;
      Floats y;
      Floats z;
      Floats offset;
      std::memcpy(&x, &block.x[8 * bit], sizeof(x));
      std::memcpy(&y, &block.y[8 * bit], sizeof(y));
      std::memcpy(&z, &block.z[8 * bit], sizeof(z));
      std::memcpy(&offset, &block.offset[8 * bit], sizeof(offset));
      const Floats value = (x * light.x + y * light.y) + (z * light.z + offset * light.w);
      // A comparison gives -1 or 0 a lane.
      above |= (value > light.bound) & (std::int32_t{1} << bit);
      below |= (value < -light.bound) & (std::int32_t{1} << bit);
    }
    const Bytes aboveBytes = __builtin_convertvector(above, Bytes);
    const Bytes belowBytes = __builtin_convertvector(below, Bytes);
    std::memcpy(&towards[index], &aboveBytes, sizeof(aboveBytes));
    std::memcpy(&away[index], &belowBytes, sizeof(belowBytes));
  }
}

void compareAsBuilt(const PlaneBlock* blocks, std::size_t count, const ScaledLight& light,
                    std::uint64_t* towards, std::uint64_t* away)
{
  compareVectors(blocks, count, light, towards, away);
}

#endif

#ifdef SHADOW_HAS_AVX2

__attribute__((target("avx2"))) void compareAvx2(const PlaneBlock* blocks, std::size_t count,
                                                 const ScaledLight& light, std::uint64_t* towards,
                                                 std::uint64_t* away)
{
  compareVectors(blocks, count, light, towards, away);
}

#endif

std::vector<InstructionSet> findInstructionSets()
{
  std::vector<InstructionSet> sets = {InstructionSet::Scalar};
#ifdef SHADOW_HAS_VECTORS
  sets.push_back(InstructionSet::Vector);
#endif
#ifdef SHADOW_HAS_AVX2
  if (__builtin_cpu_supports("avx2"))
  {
    sets.push_back(InstructionSet::Avx2);
  }
#endif
  return sets;
}

} // namespace

const std::vector<InstructionSet>& getInstructionSets()
{
  static const std::vector<InstructionSet> sets = findInstructionSets();
  return sets;
}

PlaneKernel getPlaneKernel(InstructionSet set)
{
#ifdef SHADOW_HAS_AVX2
  if (set == InstructionSet::Avx2)
  {
    return compareAvx2;
  }
#endif
#ifdef SHADOW_HAS_VECTORS
  if (set == InstructionSet::Vector)
  {
    return compareAsBuilt;
  }
#endif
  static_cast<void>(set);
  return compareScalar;
}

} // namespace shadow
