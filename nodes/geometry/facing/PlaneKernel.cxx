#include "PlaneKernel.h"

#include <cstring>

#include "Avx2.h"
#include "FacingBits.h"

// Vectors of GCC and Clang.
#ifdef __GNUC__
#define SHADOW_HAS_VECTORS
#endif

namespace shadow
{

namespace
{

/// Of the 16 triangles of a quarter: the bits of those above the bound, and, 16 bits higher, of those below.
std::uint32_t compareScalar(const PlaneBlock& block, std::size_t quarter, const LightInUnits& light)
{
  std::uint32_t bits = 0;
  for (std::size_t triangle = 0; triangle < PlaneBlock::quarter; ++triangle)
  {
    const glm::ivec4 plane = block.getUnits(PlaneBlock::quarter * quarter + triangle);
    const std::int32_t value = plane.x * light.x + plane.y * light.y + plane.z * light.z + plane.w * light.w;
    bits |= std::uint32_t{value > light.bound} << triangle;
    bits |= std::uint32_t{value < -light.bound} << (PlaneBlock::quarter + triangle);
  }
  return bits;
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

/// The bits of 16 triangles from their lanes, where bit 4 i of lane l belongs to slot 8 i + l.
std::uint32_t gatherBits(const Eight& lanes)
{
  std::uint32_t bits = 0;
  for (unsigned int lane = 0; lane < 8; ++lane)
  {
    bits |= static_cast<std::uint32_t>(lanes[lane]) << (lane % 4 + 8 * (lane / 4));
  }
  return bits;
}

/// As compareScalar().
std::uint32_t compareVectors(const PlaneBlock& block, std::size_t quarter, const LightInUnits& light)
{
  Eight above{};
  Eight below{};
  for (std::size_t group = 0; group < 2; ++group)
  {
    const std::size_t slot = PlaneBlock::quarter * quarter + 8 * group;
    Eight values{};
    addProducts(&block.xy[slot], light.x, light.y, values);
    addProducts(&block.zOffset[slot], light.z, light.w, values);
    // A comparison gives -1 or 0 a lane.
    above |= (values > light.bound) & (1 << 4 * group);
    below |= (values < -light.bound) & (1 << 4 * group);
  }
  return gatherBits(above) | gatherBits(below) << PlaneBlock::quarter;
}

#endif

/// PlaneKernel from a function for one quarter.
template <auto compareQuarter>
struct FromQuarters
{
  static void compareBlocks(const PlaneBlock* blocks, std::size_t count, const LightInUnits& light,
                            std::uint64_t* towards, std::uint64_t* away)
  {
    for (std::size_t index = 0; index < count; ++index)
    {
      towards[index] = 0;
      away[index] = 0;
      compareQuarters(blocks[index], 0xf, light, towards[index], away[index]);
    }
  }

  static void compareQuarters(const PlaneBlock& block, unsigned int quarters, const LightInUnits& light,
                              std::uint64_t& towards, std::uint64_t& away)
  {
    for (std::size_t quarter = 0; quarter < PlaneBlock::triangles / PlaneBlock::quarter; ++quarter)
    {
      if ((quarters >> quarter & 1u) != 0)
      {
        const std::uint32_t bits = compareQuarter(block, quarter, light);
        towards |= std::uint64_t{bits & 0xffffu} << (PlaneBlock::quarter * quarter);
        away |= std::uint64_t{bits >> PlaneBlock::quarter} << (PlaneBlock::quarter * quarter);
      }
    }
  }

  static constexpr PlaneKernel kernel = {compareBlocks, compareQuarters};
};

#ifdef SHADOW_HAS_AVX2

/// A light in all lanes.
struct LightLanes
{
  __m256i xy;
  __m256i zw;
  __m256i bound;
  __m256i negativeBound;
};

SHADOW_INLINE_AVX2 __m256i spreadPair(std::int16_t first, std::int16_t second)
{
  const PlaneBlock::Pair pair = {first, second};
  std::int32_t lane = 0;
  std::memcpy(&lane, pair.data(), sizeof(lane));
  return _mm256_set1_epi32(lane);
}

SHADOW_INLINE_AVX2 LightLanes spreadLight(const LightInUnits& light)
{
  return {spreadPair(light.x, light.y), spreadPair(light.z, light.w), _mm256_set1_epi32(light.bound),
          _mm256_set1_epi32(-light.bound)};
}

/// Compares the 16 triangles of a quarter: -1 a lane in @p above or @p below.
SHADOW_INLINE_AVX2 void compareLanes(const PlaneBlock& block, std::size_t quarter, const LightLanes& light,
                                     __m256i* above, __m256i* below)
{
  const auto* xy = reinterpret_cast<const __m256i*>(&block.xy[PlaneBlock::quarter * quarter]);
  const auto* zOffset = reinterpret_cast<const __m256i*>(&block.zOffset[PlaneBlock::quarter * quarter]);
  for (std::size_t group = 0; group < 2; ++group)
  {
    const __m256i value = _mm256_add_epi32(_mm256_madd_epi16(_mm256_load_si256(xy + group), light.xy),
                                           _mm256_madd_epi16(_mm256_load_si256(zOffset + group), light.zw));
    above[group] = _mm256_cmpgt_epi32(value, light.bound);
    below[group] = _mm256_cmpgt_epi32(light.negativeBound, value);
  }
}

/// The bits of two times 16 triangles from their lanes.
SHADOW_INLINE_AVX2 std::uint64_t packBits(const __m256i* first, const __m256i* second)
{
  // Packing works within halves of vectors: four parts come out as 0, 2, 1, 3.
  const __m256i bytes =
      _mm256_packs_epi16(_mm256_packs_epi32(first[0], first[1]), _mm256_packs_epi32(second[0], second[1]));
  return static_cast<std::uint32_t>(
      _mm256_movemask_epi8(_mm256_permute4x64_epi64(bytes, _MM_SHUFFLE(3, 1, 2, 0))));
}

SHADOW_TARGET_AVX2 void compareBlocksAvx2(const PlaneBlock* blocks, std::size_t count,
                                          const LightInUnits& light, std::uint64_t* towards,
                                          std::uint64_t* away)
{
  const LightLanes lanes = spreadLight(light);
  for (std::size_t index = 0; index < count; ++index)
  {
    __m256i above[8];
    __m256i below[8];
    for (std::size_t quarter = 0; quarter < 4; ++quarter)
    {
      compareLanes(blocks[index], quarter, lanes, above + 2 * quarter, below + 2 * quarter);
    }
    towards[index] = packBits(above, above + 2) | packBits(above + 4, above + 6) << 32;
    away[index] = packBits(below, below + 2) | packBits(below + 4, below + 6) << 32;
  }
}

SHADOW_TARGET_AVX2 void compareQuartersAvx2(const PlaneBlock& block, unsigned int quarters,
                                            const LightInUnits& light, std::uint64_t& towards,
                                            std::uint64_t& away)
{
  const LightLanes lanes = spreadLight(light);
  for (; quarters != 0; quarters &= quarters - 1)
  {
    const std::size_t quarter = findLowestBit(quarters);
    __m256i above[2];
    __m256i below[2];
    compareLanes(block, quarter, lanes, above, below);
    const std::uint64_t bits = packBits(above, below);
    towards |= (bits & 0xffffu) << PlaneBlock::quarter * quarter;
    away |= (bits >> PlaneBlock::quarter) << PlaneBlock::quarter * quarter;
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
    return {compareBlocksAvx2, compareQuartersAvx2};
  }
#endif
#ifdef SHADOW_HAS_VECTORS
  if (set == InstructionSet::Vector)
  {
    return FromQuarters<compareVectors>::kernel;
  }
#endif
  static_cast<void>(set);
  return FromQuarters<compareScalar>::kernel;
}

} // namespace shadow
