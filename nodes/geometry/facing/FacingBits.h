#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace shadow
{

/// The lowest set bit of a word that has one.
inline std::size_t findLowestBit(std::uint64_t word)
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

/// A word of which so many of the lowest bits are set; all of them from 64 on.
inline std::uint64_t lowestBits(std::size_t count)
{
  return count < 64 ? (std::uint64_t{1} << count) - 1 : ~std::uint64_t{0};
}

/// One bit per triangle, 64 to a word. Bit t lives in word t / 64.
///
/// Every step that needs to know how a triangle faces a light reads it here, so no two steps can disagree.
class FacingBits
{
public:
  FacingBits() = default;

  /// All bits cleared. @p size  number of triangles
  explicit FacingBits(std::size_t size) { this->assign(size); }

  /// Resizes to @p size triangles and clears every bit; keeps the memory it has.
  void assign(std::size_t size)
  {
    this->count = size;
    this->words.assign((size + 63) / 64, 0);
  }

  /// Resizes to @p size triangles and leaves it to the caller to write every word.
  void resize(std::size_t size)
  {
    this->count = size;
    this->words.resize((size + 63) / 64);
  }

  /// Clears the bits of the last word that no triangle has.
  void clearBeyondEnd()
  {
    if (this->count % 64 != 0)
    {
      this->words.back() &= lowestBits(this->count % 64);
    }
  }

  bool test(std::size_t triangle) const { return (this->words[triangle >> 6] >> (triangle & 63)) & 1u; }
  void set(std::size_t triangle) { this->words[triangle >> 6] |= std::uint64_t{1} << (triangle & 63); }

  /// Number of triangles.
  std::size_t size() const { return this->count; }

  /// Number of set bits. Cost: O(triangles / 64).
  std::size_t countSet() const;

  std::uint64_t* data() { return this->words.data(); }
  const std::vector<std::uint64_t>& getWords() const { return this->words; }

private:
  std::vector<std::uint64_t> words;
  std::size_t count = 0;
};

/// How every triangle of a mesh faces one light.
///
/// A triangle with the light in its plane has neither bit: its shadow has no area, so it casts none. All
/// triangles that meet in a vertex at the light are such.
struct LightFacing
{
  FacingBits towards; ///< the light is in front of the oriented triangle (its normal's side)
  FacingBits away;    ///< the light is behind the oriented triangle

  /// Words that may have an edge on the silhouette, rising; no edge of another word (see EdgeTable) lies
  /// between triangles that differ in their bits. Nothing: any word may. To be reset by whoever changes bits.
  std::optional<std::vector<std::uint32_t>> mixedWords = std::nullopt;
};

} // namespace shadow
