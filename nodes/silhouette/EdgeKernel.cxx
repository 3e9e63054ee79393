#include "EdgeKernel.h"

#include <algorithm>

#include "Avx2.h"
#include "FacingBits.h"

namespace shadow
{

namespace
{

/// No inner edge differs where all triangles of the word face alike.
bool isUniform(std::size_t word, const std::uint64_t* towards, const std::uint64_t* away)
{
  const auto isOne = [](std::uint64_t bits) { return bits == 0 || bits == ~std::uint64_t{0}; };
  return isOne(towards[word]) && (away == nullptr || isOne(away[word]));
}

using Record = EdgeTable::Record;

// Each number of an edge found is stored by itself: one that was put together in memory and then copied as a
// whole would have to wait for its parts.

/// Writes the inner edges begin + i of a word for each bit i. @return  the place behind the last one
DifferingEdge* writeInner(const Record& record, std::uint64_t differing, std::size_t word, std::size_t begin,
                          DifferingEdge* found)
{
  const auto base = static_cast<std::uint32_t>(64 * word);
  for (; differing != 0; differing &= differing - 1, ++found)
  {
    const std::size_t edge = begin + findLowestBit(differing);
    const EdgeTable::Code code = record.innerFirst[edge];
    found->first = base + EdgeTable::triangleOf(code);
    found->side = EdgeTable::sideOf(code);
    found->second = base + EdgeTable::triangleOf(record.innerSecond[edge]);
  }
  return found;
}

/// The same for outer edges.
DifferingEdge* writeOuter(const Record& record, std::uint64_t differing, std::size_t word, std::size_t begin,
                          DifferingEdge* found)
{
  const auto base = static_cast<std::uint32_t>(64 * word);
  for (; differing != 0; differing &= differing - 1, ++found)
  {
    const std::size_t edge = begin + findLowestBit(differing);
    const EdgeTable::Code code = record.outerFirst[edge];
    found->first = base + EdgeTable::triangleOf(code);
    found->side = EdgeTable::sideOf(code);
    found->second = record.outerSecond[edge];
  }
  return found;
}

/// @name  The edges of one word, written from a place on. For all instruction sets the same
/// @{

DifferingEdge* compareInnerScalar(const Record& record, std::size_t word, const std::uint64_t* towards,
                                  const std::uint64_t* away, DifferingEdge* found)
{
  const std::uint64_t up = towards[word];
  const std::uint64_t down = away != nullptr ? away[word] : 0;
  for (std::size_t begin = 0; begin < record.inner; begin += 64)
  {
    const std::size_t count = std::min<std::size_t>(64, record.inner - begin);
    std::uint64_t differing = 0;
    for (std::size_t edge = 0; edge < count; ++edge)
    {
      const std::uint32_t first = EdgeTable::triangleOf(record.innerFirst[begin + edge]);
      const std::uint32_t second = EdgeTable::triangleOf(record.innerSecond[begin + edge]);
      const std::uint64_t different = ((up >> first) ^ (up >> second)) | ((down >> first) ^ (down >> second));
      differing |= (different & 1u) << edge;
    }
    found = writeInner(record, differing, word, begin, found);
  }
  return found;
}

DifferingEdge* compareOuterScalar(const Record& record, std::size_t word, const std::uint64_t* towards,
                                  const std::uint64_t* away, DifferingEdge* found)
{
  for (std::size_t begin = 0; begin < record.outer; begin += 64)
  {
    const std::size_t count = std::min<std::size_t>(64, record.outer - begin);
    std::uint64_t differing = 0;
    for (std::size_t edge = 0; edge < count; ++edge)
    {
      const std::uint32_t first = EdgeTable::triangleOf(record.outerFirst[begin + edge]);
      const std::uint32_t second = record.outerSecond[begin + edge];
      std::uint64_t different = (towards[word] >> first) ^ (towards[second >> 6] >> (second & 63u));
      if (away != nullptr)
      {
        different |= (away[word] >> first) ^ (away[second >> 6] >> (second & 63u));
      }
      differing |= (different & 1u) << edge;
    }
    found = writeOuter(record, differing, word, begin, found);
  }
  return found;
}

#ifdef SHADOW_HAS_AVX2

/// For 32 codes: -1 where the bit of the triangle is 0.
SHADOW_INLINE_AVX2 __m256i findClear(__m256i codes, __m256i bits)
{
  const __m256i seven = _mm256_set1_epi8(7);
  const __m256i singleBits = _mm256_set1_epi64x(static_cast<long long>(0x8040201008040201u));
  // The triangle is the lower six bits of a code: three for the bit in a byte, three for the byte.
  const __m256i byte = _mm256_and_si256(_mm256_srli_epi16(codes, 3), seven);
  const __m256i bit = _mm256_and_si256(codes, seven);
  return _mm256_cmpeq_epi8(
      _mm256_and_si256(_mm256_shuffle_epi8(bits, byte), _mm256_shuffle_epi8(singleBits, bit)),
      _mm256_setzero_si256());
}

/// Of 32 inner edges: a bit for each whose triangles differ.
SHADOW_INLINE_AVX2 std::uint64_t compareInner32(const Record& record, std::size_t begin,
                                                std::uint64_t towards, const std::uint64_t* away)
{
  const __m256i first = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(record.innerFirst + begin));
  const __m256i second = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(record.innerSecond + begin));
  const __m256i up = _mm256_set1_epi64x(static_cast<long long>(towards));
  __m256i different = _mm256_xor_si256(findClear(first, up), findClear(second, up));
  if (away != nullptr)
  {
    const __m256i down = _mm256_set1_epi64x(static_cast<long long>(*away));
    different = _mm256_or_si256(different, _mm256_xor_si256(findClear(first, down), findClear(second, down)));
  }
  return static_cast<std::uint32_t>(_mm256_movemask_epi8(different));
}

/// 32 edges at a time, those read beyond the end of the word left out.
SHADOW_TARGET_AVX2 inline DifferingEdge* compareInnerAvx2(const Record& record, std::size_t word,
                                                          const std::uint64_t* towards,
                                                          const std::uint64_t* away, DifferingEdge* found)
{
  const std::uint64_t* down = away != nullptr ? away + word : nullptr;
  for (std::size_t begin = 0; begin < record.inner; begin += 64)
  {
    std::uint64_t differing = compareInner32(record, begin, towards[word], down);
    if (record.inner - begin > 32)
    {
      differing |= compareInner32(record, begin + 32, towards[word], down) << 32;
    }
    // Written 64 at a time: how often such a loop runs, no processor can foresee.
    found = writeInner(record, differing & lowestBits(record.inner - begin), word, begin, found);
  }
  return found;
}

/// For 8 outer edges of a word: the upper bit says that the triangles differ in their bits.
SHADOW_INLINE_AVX2 __m256i findDifferent(__m256i first, __m256i second, const std::uint64_t* bits,
                                         std::size_t word)
{
  // In halves of words, as there are eight of them in a vector; the lower half comes first.
  const auto* halves = reinterpret_cast<const int*>(bits);
  const __m256i own = _mm256_set1_epi64x(static_cast<long long>(bits[word]));
  const __m256i low = _mm256_set1_epi32(31);
  const __m256i firstBits = _mm256_srlv_epi32(_mm256_permutevar8x32_epi32(own, _mm256_srli_epi32(first, 5)),
                                              _mm256_and_si256(first, low));
  const __m256i secondBits = _mm256_srlv_epi32(
      _mm256_i32gather_epi32(halves, _mm256_srli_epi32(second, 5), 4), _mm256_and_si256(second, low));
  return _mm256_slli_epi32(_mm256_xor_si256(firstBits, secondBits), 31);
}

/// 8 edges at a time, those read beyond the end of the word left out.
SHADOW_TARGET_AVX2 inline DifferingEdge* compareOuterAvx2(const Record& record, std::size_t word,
                                                          const std::uint64_t* towards,
                                                          const std::uint64_t* away, DifferingEdge* found)
{
  for (std::size_t begin = 0; begin < record.outer; begin += 64)
  {
    std::uint64_t differing = 0;
    for (std::size_t edge = begin; edge < std::min(begin + 64, record.outer); edge += 8)
    {
      const __m128i codes = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(record.outerFirst + edge));
      const __m256i first = _mm256_and_si256(_mm256_cvtepu8_epi32(codes), _mm256_set1_epi32(63));
      const __m256i second = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(record.outerSecond + edge));
      // What stands behind the last edge is no triangle: it must not be looked up.
      const __m256i isEdge = _mm256_cmpgt_epi32(_mm256_set1_epi32(static_cast<int>(record.outer - edge)),
                                                _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
      const __m256i known = _mm256_and_si256(second, isEdge);
      __m256i different = findDifferent(first, known, towards, word);
      if (away != nullptr)
      {
        different = _mm256_or_si256(different, findDifferent(first, known, away, word));
      }
      const int upper = _mm256_movemask_ps(_mm256_castsi256_ps(different));
      differing |= static_cast<std::uint64_t>(upper) << (edge - begin);
    }
    found = writeOuter(record, differing & lowestBits(record.outer - begin), word, begin, found);
  }
  return found;
}

SHADOW_TARGET_AVX2 DifferingEdge* compareAllAvx2(const EdgeTable& table, const std::uint64_t* towards,
                                                 const std::uint64_t* away, std::size_t firstWord,
                                                 std::size_t endWord, DifferingEdge* found)
{
  for (std::size_t word = firstWord; word < endWord; ++word)
  {
    const Record record = table.getRecord(word);
    if (!isUniform(word, towards, away))
    {
      found = compareInnerAvx2(record, word, towards, away, found);
    }
    found = compareOuterAvx2(record, word, towards, away, found);
  }
  return found;
}

#endif

/// @}

DifferingEdge* compareAllScalar(const EdgeTable& table, const std::uint64_t* towards,
                                const std::uint64_t* away, std::size_t firstWord, std::size_t endWord,
                                DifferingEdge* found)
{
  for (std::size_t word = firstWord; word < endWord; ++word)
  {
    const Record record = table.getRecord(word);
    if (!isUniform(word, towards, away))
    {
      found = compareInnerScalar(record, word, towards, away, found);
    }
    found = compareOuterScalar(record, word, towards, away, found);
  }
  return found;
}

} // namespace

EdgeKernel getEdgeKernel(InstructionSet set)
{
#ifdef SHADOW_HAS_AVX2
  if (set == InstructionSet::Avx2)
  {
    return compareAllAvx2;
  }
#endif
  static_cast<void>(set);
  return compareAllScalar;
}

} // namespace shadow
