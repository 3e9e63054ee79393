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

/// Appends the inner edges begin + i of a word for each bit i.
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

/// The same for outer edges.
void appendOuter(const EdgeTable& table, std::uint64_t differing, std::size_t word, std::size_t begin,
                 std::vector<DifferingEdge>& found)
{
  const auto base = static_cast<std::uint32_t>(64 * word);
  for (; differing != 0; differing &= differing - 1)
  {
    const std::size_t edge = begin + findLowest(differing);
    const EdgeTable::Code code = table.outerFirst[edge];
    found.push_back({base + EdgeTable::triangleOf(code), EdgeTable::sideOf(code), table.outerSecond[edge]});
  }
}

void compareInnerScalar(const EdgeTable& table, const std::uint64_t* towards, const std::uint64_t* away,
                        std::size_t firstWord, std::size_t endWord, std::vector<DifferingEdge>& found)
{
  for (std::size_t word = firstWord; word < endWord; ++word)
  {
    const std::uint64_t up = towards[word];
    const std::uint64_t down = away != nullptr ? away[word] : 0;
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
            ((up >> first) ^ (up >> second)) | ((down >> first) ^ (down >> second));
        differing |= (different & 1u) << edge;
      }
      appendInner(table, differing, word, begin, found);
    }
  }
}

void compareOuterScalar(const EdgeTable& table, const std::uint64_t* towards, const std::uint64_t* away,
                        std::size_t firstWord, std::size_t endWord, std::vector<DifferingEdge>& found)
{
  for (std::size_t word = firstWord; word < endWord; ++word)
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
      appendOuter(table, differing, word, begin, found);
    }
  }
}

#ifdef SHADOW_HAS_AVX2

/// For 32 codes: -1 where the bit of the triangle is 0.
__attribute__((target("avx2"), always_inline)) inline __m256i findClear(__m256i codes, __m256i bits)
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

/// 32 edges at a time, those read beyond the end of the word left out.
__attribute__((target("avx2"))) void compareInnerAvx2(const EdgeTable& table, const std::uint64_t* towards,
                                                      const std::uint64_t* away, std::size_t firstWord,
                                                      std::size_t endWord, std::vector<DifferingEdge>& found)
{
  for (std::size_t word = firstWord; word < endWord; ++word)
  {
    const __m256i up = _mm256_set1_epi64x(static_cast<long long>(towards[word]));
    const std::size_t end = table.innerBegins[word + 1];
    for (std::size_t begin = table.innerBegins[word]; begin < end; begin += 32)
    {
      const auto* firsts = reinterpret_cast<const __m256i*>(table.innerFirst.data() + begin);
      const auto* seconds = reinterpret_cast<const __m256i*>(table.innerSecond.data() + begin);
      const __m256i first = _mm256_loadu_si256(firsts);
      const __m256i second = _mm256_loadu_si256(seconds);
      __m256i different = _mm256_xor_si256(findClear(first, up), findClear(second, up));
      if (away != nullptr)
      {
        const __m256i down = _mm256_set1_epi64x(static_cast<long long>(away[word]));
        different =
            _mm256_or_si256(different, _mm256_xor_si256(findClear(first, down), findClear(second, down)));
      }
      const std::size_t count = end - begin;
      const std::uint32_t wanted = count < 32 ? (1u << count) - 1 : ~0u;
      appendInner(table, static_cast<std::uint32_t>(_mm256_movemask_epi8(different)) & wanted, word, begin,
                  found);
    }
  }
}

/// For 8 outer edges of a word: the upper bit says that the triangles differ in their bits.
__attribute__((target("avx2"), always_inline)) inline __m256i
findDifferent(__m256i first, __m256i second, const std::uint64_t* bits, std::size_t word)
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
__attribute__((target("avx2"))) void compareOuterAvx2(const EdgeTable& table, const std::uint64_t* towards,
                                                      const std::uint64_t* away, std::size_t firstWord,
                                                      std::size_t endWord, std::vector<DifferingEdge>& found)
{
  const __m256i triangle = _mm256_set1_epi32(63);
  for (std::size_t word = firstWord; word < endWord; ++word)
  {
    const std::size_t end = table.outerBegins[word + 1];
    for (std::size_t begin = table.outerBegins[word]; begin < end; begin += 8)
    {
      const auto* firsts = reinterpret_cast<const __m128i*>(table.outerFirst.data() + begin);
      const auto* seconds = reinterpret_cast<const __m256i*>(table.outerSecond.data() + begin);
      const __m256i first = _mm256_and_si256(_mm256_cvtepu8_epi32(_mm_loadl_epi64(firsts)), triangle);
      const __m256i second = _mm256_loadu_si256(seconds);
      __m256i different = findDifferent(first, second, towards, word);
      if (away != nullptr)
      {
        different = _mm256_or_si256(different, findDifferent(first, second, away, word));
      }
      const std::size_t count = end - begin;
      const std::uint32_t wanted = count < 8 ? (1u << count) - 1 : ~0u;
      const int upper = _mm256_movemask_ps(_mm256_castsi256_ps(different));
      appendOuter(table, static_cast<std::uint32_t>(upper) & wanted, word, begin, found);
    }
  }
}

#endif

} // namespace

EdgeKernels getEdgeKernels(InstructionSet set)
{
#ifdef SHADOW_HAS_AVX2
  if (set == InstructionSet::Avx2)
  {
    return {compareInnerAvx2, compareOuterAvx2};
  }
#endif
  static_cast<void>(set);
  return {compareInnerScalar, compareOuterScalar};
}

} // namespace shadow
