#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

#include <glm/glm.hpp>

namespace shadow::fuzz
{

/// Random numbers that are the same on every platform: the standard fixes its generators, but not its
/// distributions, nor the last digits of its sines and powers.
class FuzzRandom
{
public:
  /// @param seed   of a run
  /// @param scene  number of the scene in the run
  FuzzRandom(std::uint64_t seed, std::uint64_t scene)
      : generator(seed * 0x9e3779b97f4a7c15u + scene * 0xd1342543de82ef95u + 1)
  {
  }

  /// 0 up to but not including 1.
  double real() { return static_cast<double>(this->generator() >> 11u) * (1.0 / 9007199254740992.0); }

  double between(double low, double high) { return low + (high - low) * this->real(); }

  /// 0 up to but not including @p count.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(this->generator() % count); }

  /// @p low to @p high.
  int integer(int low, int high)
  {
    return low + static_cast<int>(this->below(static_cast<std::size_t>(high - low + 1)));
  }

  bool chance(double probability) { return this->real() < probability; }

  glm::dvec3 inCube(double reach)
  {
    const double x = this->between(-reach, reach);
    const double y = this->between(-reach, reach);
    return {x, y, this->between(-reach, reach)};
  }

  /// Of unit length.
  glm::dvec3 direction()
  {
    for (;;)
    {
      const glm::dvec3 point = this->inCube(1.0);
      const double squared = glm::dot(point, point);
      if (squared > 0.01 && squared <= 1.0)
      {
        return point / glm::sqrt(squared);
      }
    }
  }

  template <class List>
  const auto& pick(const List& list)
  {
    return *(std::begin(list) + static_cast<std::ptrdiff_t>(this->below(std::size(list))));
  }

private:
  std::mt19937_64 generator;
};

/// 10 to a whole power by multiplication alone, see FuzzRandom.
inline double powerOfTen(int exponent)
{
  double power = 1.0;
  for (int i = 0; i < glm::abs(exponent); ++i)
  {
    power *= 10.0;
  }
  return exponent < 0 ? 1.0 / power : power;
}

} // namespace shadow::fuzz
