#include "PointRange.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace shadow::examples
{

void PointRange::add(const std::array<double, 3>& point)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    this->lower[i] = std::min(this->lower[i], point[i]);
    this->upper[i] = std::max(this->upper[i], point[i]);
  }
}

double PointRange::getSize() const
{
  double size = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    size = std::max(size, this->upper[i] - this->lower[i]);
  }
  return size;
}

double PointRange::getMagnitude() const
{
  double magnitude = 0.0;
  for (std::size_t i = 0; i < 3 && this->lower[i] <= this->upper[i]; ++i)
  {
    magnitude = std::max({magnitude, std::abs(this->lower[i]), std::abs(this->upper[i])});
  }
  return magnitude;
}

bool PointRange::isFar() const
{
  return this->getMagnitude() * 0x1p-24 > 1e-6 * this->getSize();
}

std::array<double, 3> PointRange::getShift() const
{
  std::array<double, 3> shift = {0.0, 0.0, 0.0};
  for (std::size_t i = 0; i < 3 && this->isFar(); ++i)
  {
    shift[i] = std::round(0.5 * this->lower[i] + 0.5 * this->upper[i]);
  }
  return shift;
}

std::string PointRange::describeStep() const
{
  const double magnitude = this->getMagnitude();
  const double step = magnitude > 0.0 ? std::exp2(std::floor(std::log2(magnitude)) - 23.0) : 0.0;
  if (step <= this->getSize() / 4096.0)
  {
    return {};
  }
  std::ostringstream text;
  text << "its points are stored in single precision, which has steps of " << step << " there";
  return text.str();
}

} // namespace shadow::examples
