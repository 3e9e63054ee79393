#include "EdgeKernel.h"

#include <algorithm>

#if defined(__GNUC__) && defined(__x86_64__)
#define SHADOW_HAS_AVX2
#include <immintrin.h>
#endif

namespace shadow
{

namespace
{

/// The lowest set bit of a word that has one.
std::size_t findLowest(std::uint64_t word)
{
#ifdef __GNUC__
  return static_cast<std::size_t>(__builtin_ctzll(word));
#else
  std::size_t bit = 0;
  for (; (word & 1u) == 0; word >>= 1)
  {
    ++bit;
  }
  return bit;
#endif
}

void appendInner(const EdgeTable& table, std::uint64_t differing, std::size_t word, std::size_t begin,
                 std::vector<DifferingEdge>& found)
{
  const auto base = static_cast<std::uint32_t>(64 * word);
  for (; differing != 0; differing &= differing - 1)
  {
    const std::size_t edge = begin + findLowest(differing);
    const EdgeTable::Code code = table.innerFirst[edge];
    found.push_back({base + EdgeTable::triangleOf(code), EdgeTable::sideOf(code),
                     base + EdgeTable::triangleOf(table.innerSecond[edge])});
  }
}

/// Looks at the inner edges of one word, 64 at a time.
void compareInner(const EdgeTable& table, std::size_t word, std::uint64_t towards, std::uint64_t away,
                  std::vector<DifferingEdge>& found)
{
  const std::size_t end = table.innerBegins[word + 1];
  for (std::size_t begin = table.innerBegins[word]; begin < end; begin += 64)
  {
    const std::size_t count = std::min<std::size_t>(64, end - begin);
    std::uint64_t differing = 0;
    for (std::size_t edge = 0; edge < count; ++edge)
    {
      const std::uint32_t first = EdgeTable::triangleOf(table.innerFirst[begin + edge]);
      const std::uint32_t second = EdgeTable::triangleOf(table.innerSecond[begin + edge]);
      const std::uint64_t different =
          ((towards >> first) ^ (towards >> second)) | ((away >> first) ^ (away >> second));
      differing |= (different & 1u) << edge;
    }
    appendInner(table, differing, word, begin, found);
  }
}

} // namespace

void compareOuterEdges(const EdgeTable& table, const std::uint64_t* towards, const std::uint64_t* away,
                       std::size_t word, std::vector<DifferingEdge>& found)
{
  const std::size_t end = table.outerBegins[word + 1];
  for (std::size_t begin = table.outerBegins[word]; begin < end; begin += 64)
  {
    const std::size_t count = std::min<std::size_t>(64, end - begin);
    std::uint64_t differing = 0;
    for (std::size_t edge = 0; edge < count; ++edge)
    {
      const std::uint32_t first = EdgeTable::triangleOf(table.outerFirst[begin + edge]);
      const std::uint32_t second = table.outerSecond[begin + edge];
      std::uint64_t different = (towards[word] >> first) ^ (towards[second >> 6] >> (second & 63u));
      if (away != nullptr)
      {
        different |= (away[word] >> first) ^ (away[second >> 6] >> (second & 63u));
      }
      differing |= (different & 1u) << edge;
    }
    for (; differing != 0; differing &= differing - 1)
    {
      const std::size_t edge = begin + findLowest(differing);
      const EdgeTable::Code code = table.outerFirst[edge];
      found.push_back({static_cast<std::uint32_t>(64 * word) + EdgeTable::triangleOf(code),
                       EdgeTable::sideOf(code), table.outerSecond[edge]});
    }
  }
}

namespace
{

void compareScalar(const EdgeTable& table, const std::uint64_t* towards, const std::uint64_t* away,
                   std::size_t firstWord, std::size_t endWord, std::vector<DifferingEdge>& found)
{
  for (std::size_t word = firstWord; word < endWord; ++word)
  {
    compareInner(table, word, towards[word], away != nullptr ? away[word] : 0, found);
    compareOuterEdges(table, towards, away, word, found);
  }
}

#ifdef SHADOW_HAS_AVX2

__attribute__((target("avx2"), always_inline)) inline __m256i loadCodes(const EdgeTable::Code* codes)
{
  return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(codes));
}

/// For 32 codes: -1 where the bit of the triangle is 0.
__attribute__((target("avx2"), always_inline)) inline __m256i findClear(__m256i codes, __m256i bits)
{
  const __m256i seven = _mm256_set1_epi8(7);
  const __m256i singleBits = _mm256_set1_epi64x(static_cast<long long>(0x8040201008040201u));
  // The triangle is the upper six bits of a code: three for the byte of the word, three for the bit in it.
  const __m256i byte = _mm256_and_si256(_mm256_srli_epi16(codes, 5), seven);
  const __m256i bit = _mm256_and_si256(_mm256_srli_epi16(codes, 2), seven);
  return _mm256_cmpeq_epi8(
      _mm256_and_si256(_mm256_shuffle_epi8(bits, byte), _mm256_shuffle_epi8(singleBits, bit)),
      _mm256_setzero_si256());
}

/// Looks at the inner edges of one word, 32 at a time, those read beyond its end left out.
__attribute__((target("avx2"))) inline void compareInnerAvx2(const EdgeTable& table, std::size_t word,
                                                             std::uint64_t towards, std::uint64_t away,
                                                             std::vector<DifferingEdge>& found)
{
  const __m256i towardsBits = _mm256_set1_epi64x(static_cast<long long>(towards));
  const __m256i awayBits = _mm256_set1_epi64x(static_cast<long long>(away));
  const std::size_t end = table.innerBegins[word + 1];
  for (std::size_t begin = table.innerBegins[word]; begin < end; begin += 32)
  {
    const __m256i first = loadCodes(table.innerFirst.data() + begin);
    const __m256i second = loadCodes(table.innerSecond.data() + begin);
    __m256i different = _mm256_xor_si256(findClear(first, towardsBits), findClear(second, towardsBits));
    if (away != 0)
    {
      different = _mm256_or_si256(different,
                                  _mm256_xor_si256(findClear(first, awayBits), findClear(second, awayBits)));
    }
    auto differing = static_cast<std::uint32_t>(_mm256_movemask_epi8(different));
    if (differing != 0)
    {
      const std::size_t count = end - begin;
      differing &= count < 32 ? (1u << count) - 1 : ~0u;
      appendInner(table, differing, word, begin, found);
    }
  }
}

__attribute__((target("avx2"))) void compareAvx2(const EdgeTable& table, const std::uint64_t* towards,
                                                 const std::uint64_t* away, std::size_t firstWord,
                                                 std::size_t endWord, std::vector<DifferingEdge>& found)
{
  for (std::size_t word = firstWord; word < endWord; ++word)
  {
    compareInnerAvx2(table, word, towards[word], away != nullptr ? away[word] : 0, found);
    compareOuterEdges(table, towards, away, word, found);
  }
}

#endif

} // namespace

EdgeKernel getEdgeKernel(InstructionSet set)
{
#ifdef SHADOW_HAS_AVX2
  if (set == InstructionSet::Avx2)
  {
    return compareAvx2;
  }
#endif
  static_cast<void>(set);
  return compareScalar;
}

} // namespace shadow
