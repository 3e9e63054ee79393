#include "ExactOrientation.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace shadow
{

namespace
{

/// A sum of doubles that do not overlap, by rising magnitude: holds a number exactly.
///
/// The longest one needed: differences of floats have 2 terms, their products 8, a normal's coordinate 16,
/// the light relative to a corner 3, their product 96, and three of these 288.
class Expansion
{
public:
  /// Shewchuk's Grow-Expansion, leaving out zeros.
  void add(double value)
  {
    std::size_t kept = 0;
    for (std::size_t term = 0; term < this->size; ++term)
    {
      // Two-Sum: sum + error is value + terms[term], exactly.
      const double sum = value + this->terms[term];
      const double added = sum - value;
      const double error = (value - (sum - added)) + (this->terms[term] - added);
      if (error != 0.0)
      {
        this->terms[kept++] = error;
      }
      value = sum;
    }
    if (value != 0.0)
    {
      this->terms[kept++] = value;
    }
    this->size = kept;
  }

  /// Adds left * right.
  void addProduct(double left, double right)
  {
    const double product = left * right;
    this->add(std::fma(left, right, -product));
    this->add(product);
  }

  /// Adds sign * left * right.
  void addProduct(const Expansion& left, const Expansion& right, double sign)
  {
    for (std::size_t i = 0; i < left.size; ++i)
    {
      for (std::size_t j = 0; j < right.size; ++j)
      {
        this->addProduct(sign * left.terms[i], right.terms[j]);
      }
    }
  }

  /// The sum, from the smallest term on: off by a rounding or two.
  double estimate() const
  {
    return std::accumulate(this->terms.begin(), this->terms.begin() + this->size, 0.0);
  }

  /// The largest term outweighs all others.
  int getSign() const { return this->size == 0 ? 0 : this->terms[this->size - 1] > 0.0 ? 1 : -1; }

private:
  std::array<double, 320> terms;
  std::size_t size = 0;
};

std::array<Expansion, 3> subtract(const glm::vec3& left, const glm::dvec3& right)
{
  std::array<Expansion, 3> difference;
  for (int axis = 0; axis < 3; ++axis)
  {
    difference[axis].add(left[axis]);
    difference[axis].add(-right[axis]);
  }
  return difference;
}

/// A coordinate of the cross product.
Expansion crossAt(const std::array<Expansion, 3>& left, const std::array<Expansion, 3>& right, int axis)
{
  const int y = (axis + 1) % 3;
  const int z = (axis + 2) % 3;
  Expansion coordinate;
  coordinate.addProduct(left[y], right[z], 1.0);
  coordinate.addProduct(left[z], right[y], -1.0);
  return coordinate;
}

} // namespace

int exactOrientation(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::dvec4& lightMC)
{
  const std::array<Expansion, 3> u = subtract(b, a);
  const std::array<Expansion, 3> v = subtract(c, a);
  Expansion determinant;
  for (int x = 0; x < 3; ++x)
  {
    Expansion arm;
    arm.add(lightMC[x]);
    arm.addProduct(-lightMC.w, static_cast<double>(a[x]));
    determinant.addProduct(crossAt(u, v, x), arm, 1.0);
  }
  return determinant.getSign();
}

glm::dvec3 exactCross(const glm::vec3& a, const glm::vec3& b, const glm::dvec3& lightMC)
{
  const std::array<Expansion, 3> u = subtract(a, lightMC);
  const std::array<Expansion, 3> v = subtract(b, lightMC);
  return {crossAt(u, v, 0).estimate(), crossAt(u, v, 1).estimate(), crossAt(u, v, 2).estimate()};
}

int orientation(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::dvec4& lightMC)
{
  const glm::dvec3 corner(a);
  const glm::dvec3 u = glm::dvec3(b) - corner;
  const glm::dvec3 v = glm::dvec3(c) - corner;
  const glm::dvec3 arm = glm::dvec3(lightMC) - lightMC.w * corner;
  const glm::dvec3 products = glm::abs(glm::dvec3(u.y * v.z, u.z * v.x, u.x * v.y)) +
                              glm::abs(glm::dvec3(u.z * v.y, u.x * v.z, u.y * v.x));
  const double value = glm::dot(glm::cross(u, v), arm);
  // With eps = 2^-53: 4 eps from the cross product, 2 from the arm, 3 from the dot product; 12 leaves room.
  const double bound =
      12.0 * 0x1p-53 * glm::dot(products, glm::abs(glm::dvec3(lightMC)) + glm::abs(lightMC.w * corner));
  if (std::abs(value) > bound)
  {
    return value > 0.0 ? 1 : -1;
  }
  return exactOrientation(a, b, c, lightMC);
}

} // namespace shadow
