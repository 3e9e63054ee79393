#include "ExactSign.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <stdexcept>

namespace shadow::test
{

namespace
{

/// A whole number modulo 2^1024, the upper half of which stands for negative ones.
class Whole
{
public:
  Whole() = default;

  /// value / 2^unit, which must be whole.
  Whole(double value, int unit)
  {
    if (value == 0.0)
    {
      return;
    }
    int exponent = 0;
    const double fraction = std::frexp(std::abs(value), &exponent);
    auto mantissa = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
    int shift = exponent - 53 - unit;
    for (; shift < 0; ++shift)
    {
      mantissa >>= 1;
    }
    this->limbs[shift / 32] = static_cast<std::uint32_t>(mantissa << shift % 32);
    this->limbs[shift / 32 + 1] = static_cast<std::uint32_t>(mantissa << shift % 32 >> 32);
    this->limbs[shift / 32 + 2] =
        shift % 32 == 0 ? 0 : static_cast<std::uint32_t>(mantissa >> (64 - shift % 32));
    *this = value < 0.0 ? Whole() - *this : *this;
  }

  Whole operator+(const Whole& other) const { return this->add(other, 0, 0); }
  Whole operator-(const Whole& other) const { return this->add(other, ~std::uint32_t{0}, 1); }

  Whole operator*(const Whole& other) const
  {
    Whole product;
    for (std::size_t i = 0; i < size; ++i)
    {
      std::uint64_t carry = 0;
      for (std::size_t j = 0; i + j < size && this->limbs[i] != 0; ++j)
      {
        carry += std::uint64_t{this->limbs[i]} * other.limbs[j] + product.limbs[i + j];
        product.limbs[i + j] = static_cast<std::uint32_t>(carry);
        carry >>= 32;
      }
    }
    return product;
  }

  int getSign() const
  {
    const bool zero =
        std::all_of(this->limbs.begin(), this->limbs.end(), [](std::uint32_t limb) { return limb == 0; });
    return zero ? 0 : this->limbs.back() >> 31 != 0 ? -1 : 1;
  }

private:
  static constexpr std::size_t size = 32;

  Whole add(const Whole& other, std::uint32_t turn, std::uint64_t carry) const
  {
    Whole sum;
    for (std::size_t i = 0; i < size; ++i)
    {
      carry += std::uint64_t{this->limbs[i]} + (other.limbs[i] ^ turn);
      sum.limbs[i] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    return sum;
  }

  std::array<std::uint32_t, size> limbs{}; ///< the lowest first
};

/// The power of two of the last binary digit of any of the numbers, not below those of a double.
int findUnit(std::initializer_list<glm::dvec3> points)
{
  int lowest = std::numeric_limits<int>::max();
  int highest = std::numeric_limits<int>::min();
  for (const glm::dvec3& point : points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (point[axis] != 0.0)
      {
        int exponent = 0;
        double fraction = std::frexp(point[axis], &exponent);
        highest = std::max(highest, exponent);
        while (fraction != std::floor(fraction))
        {
          fraction *= 2.0;
          --exponent;
        }
        lowest = std::min(lowest, exponent);
      }
    }
  }
  if (highest > lowest + 300)
  {
    throw std::range_error("coordinates spread over too many digits");
  }
  return highest < lowest ? 0 : lowest;
}

using Wholes = std::array<Whole, 3>;

Wholes toWholes(const glm::dvec3& point, int unit)
{
  return {Whole(point.x, unit), Whole(point.y, unit), Whole(point.z, unit)};
}

Wholes subtract(const Wholes& left, const Wholes& right)
{
  return {left[0] - right[0], left[1] - right[1], left[2] - right[2]};
}

} // namespace

int exactSign(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::dvec4& light)
{
  const int unit = findUnit({glm::dvec3(a), glm::dvec3(b), glm::dvec3(c), glm::dvec3(light)});
  const Wholes first = toWholes(glm::dvec3(a), unit);
  const Wholes u = subtract(toWholes(glm::dvec3(b), unit), first);
  const Wholes v = subtract(toWholes(glm::dvec3(c), unit), first);
  const Wholes towards = toWholes(glm::dvec3(light), unit);
  const Wholes arm = light.w == 0.0 ? towards : subtract(towards, first);
  Whole determinant;
  for (int x = 0; x < 3; ++x)
  {
    const int y = (x + 1) % 3;
    const int z = (x + 2) % 3;
    determinant = determinant + (u[y] * v[z] - u[z] * v[y]) * arm[x];
  }
  return determinant.getSign();
}

} // namespace shadow::test
