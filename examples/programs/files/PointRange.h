#ifndef shadow_examples_PointRange_h
#define shadow_examples_PointRange_h

#include <array>
#include <limits>
#include <string>

namespace shadow::examples
{

/// The box of a file's points, and what single precision would make of them.
class PointRange
{
public:
  void add(const std::array<double, 3>& point);

  /// Single precision has steps here that may be seen: over a millionth of the box's size.
  bool isFar() const;

  /// To be taken off the points so that single precision holds them: whole numbers; 0 where isFar() is false.
  std::array<double, 3> getShift() const;

  /// A warning of points that the file holds in single precision, with the distance of neighbouring numbers where
  /// they are farthest from 0; empty where that is less than a 4096th of the box's size, of which a picture shows
  /// nothing.
  std::string describeStep() const;

private:
  double getSize() const;
  double getMagnitude() const;

  static constexpr double most = std::numeric_limits<double>::max();
  std::array<double, 3> lower = {most, most, most};
  std::array<double, 3> upper = {-most, -most, -most};
};

} // namespace shadow::examples

#endif
