#include "PlaneKernel.h"

#include <cstring>

// Vectors of GCC and Clang.
#ifdef __GNUC__
#define SHADOW_HAS_VECTORS
#ifdef __x86_64__
#define SHADOW_HAS_AVX2
#include <immintrin.h>
#endif
#endif

namespace shadow
{

namespace
{

void compareScalar(const PlaneBlock* blocks, std::size_t count, const LightInUnits& light,
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
      const std::int32_t value = block.xy[slot][0] * light.x + block.xy[slot][1] * light.y +
                                 block.zOffset[slot][0] * light.z + block.zOffset[slot][1] * light.w;
      above |= std::uint64_t{value > light.bound} << bit;
      below |= std::uint64_t{value < -light.bound} << bit;
    }
    towards[index] = above;
    away[index] = below;
  }
}

#ifdef SHADOW_HAS_VECTORS

using Eight = std::int32_t __attribute__((vector_size(32)));

/// Adds the products of eight pairs with a pair of the light.
void addProducts(const PlaneBlock::Pair* pairs, std::int32_t first, std::int32_t second, Eight& sums)
{
  // The first of a pair lies in the lower half of a lane or in the upper one.
  Eight lanes;
  std::memcpy(&lanes, pairs, sizeof(lanes));
  const Eight upper = lanes >> 16;
  const Eight lower = (lanes << 16) >> 16;
#if __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
  sums += lower * first + upper * second;
#else
  sums += upper * first + lower * second;
#endif
}

/// The bits of 32 triangles from their lanes, where bit 4 i of lane l belongs to slot 8 i + l.
std::uint32_t gatherBits(const Eight& lanes)
{
  std::uint32_t bits = 0;
  for (unsigned int lane = 0; lane < 8; ++lane)
  {
    bits |= static_cast<std::uint32_t>(lanes[lane]) << (lane % 4 + 16 * (lane / 4));
  }
  return bits;
}

void compareVectors(const PlaneBlock* blocks, std::size_t count, const LightInUnits& light,
                    std::uint64_t* towards, std::uint64_t* away)
{
  for (std::size_t index = 0; index < count; ++index)
  {
    std::uint64_t bits[2] = {0, 0};
    for (std::size_t half = 0; half < 2; ++half)
    {
      Eight above{};
      Eight below{};
      for (std::size_t group = 0; group < 4; ++group)
      {
        const std::size_t slot = 32 * half + 8 * group;
        Eight values{};
        addProducts(&blocks[index].xy[slot], light.x, light.y, values);
        addProducts(&blocks[index].zOffset[slot], light.z, light.w, values);
        // A comparison gives -1 or 0 a lane.
        above |= (values > light.bound) & (1 << 4 * group);
        below |= (values < -light.bound) & (1 << 4 * group);
      }
      bits[0] |= std::uint64_t{gatherBits(above)} << 32 * half;
      bits[1] |= std::uint64_t{gatherBits(below)} << 32 * half;
    }
    towards[index] = bits[0];
    away[index] = bits[1];
  }
}

#endif

#ifdef SHADOW_HAS_AVX2

/// Two coordinates of the light, in all lanes.
__attribute__((target("avx2"), always_inline)) inline __m256i spreadPair(std::int16_t first,
                                                                         std::int16_t second)
{
  const PlaneBlock::Pair pair = {first, second};
  std::int32_t lane = 0;
  std::memcpy(&lane, pair.data(), sizeof(lane));
  return _mm256_set1_epi32(lane);
}

/// One bit a vector's lane, those of four vectors in the order of PlaneBlock::slotOf().
__attribute__((target("avx2"), always_inline)) inline std::uint64_t packBits(const __m256i (&lanes)[4])
{
  const __m256i bytes =
      _mm256_packs_epi16(_mm256_packs_epi32(lanes[0], lanes[1]), _mm256_packs_epi32(lanes[2], lanes[3]));
  return static_cast<std::uint32_t>(_mm256_movemask_epi8(bytes));
}

__attribute__((target("avx2"))) void compareAvx2(const PlaneBlock* blocks, std::size_t count,
                                                 const LightInUnits& light, std::uint64_t* towards,
                                                 std::uint64_t* away)
{
  const __m256i xy = spreadPair(light.x, light.y);
  const __m256i zw = spreadPair(light.z, light.w);
  const __m256i bound = _mm256_set1_epi32(light.bound);
  const __m256i negativeBound = _mm256_set1_epi32(-light.bound);
  for (std::size_t index = 0; index < count; ++index)
  {
    std::uint64_t aboveBits[2];
    std::uint64_t belowBits[2];
    for (std::size_t half = 0; half < 2; ++half)
    {
      const auto* pairs = reinterpret_cast<const __m256i*>(&blocks[index].xy[32 * half]);
      const auto* otherPairs = reinterpret_cast<const __m256i*>(&blocks[index].zOffset[32 * half]);
      __m256i above[4];
      __m256i below[4];
      for (std::size_t group = 0; group < 4; ++group)
      {
        const __m256i value = _mm256_add_epi32(_mm256_madd_epi16(_mm256_loadu_si256(pairs + group), xy),
                                               _mm256_madd_epi16(_mm256_loadu_si256(otherPairs + group), zw));
        above[group] = _mm256_cmpgt_epi32(value, bound);
        below[group] = _mm256_cmpgt_epi32(negativeBound, value);
      }
      aboveBits[half] = packBits(above);
      belowBits[half] = packBits(below);
    }
    towards[index] = aboveBits[0] | aboveBits[1] << 32;
    away[index] = belowBits[0] | belowBits[1] << 32;
  }
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
    return compareVectors;
  }
#endif
  static_cast<void>(set);
  return compareScalar;
}

} // namespace shadow
