#include "LargeFaces.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/gtc/matrix_access.hpp>

#include "SEDGeode.h"

namespace shadow
{

namespace
{

// Lengths that single precision can square.
constexpr int least = -60;
constexpr int most = 60;
constexpr double pixelDiagonal = 1.4142136;

} // namespace

double measurePixels(const SEDGeometry& geometry, const glm::dmat4& clipFromMC, int width, int height)
{
  const glm::dvec3 middle = 0.5 * (geometry.getLowerBound() + geometry.getUpperBound());
  const glm::dvec3 halfSize = geometry.getUpperBound() - middle;
  const glm::dvec4 toW = glm::row(clipFromMC, 3);
  const double depth = glm::dot(glm::abs(glm::dvec3(toW)), halfSize);
  const double w = std::max(glm::dot(toW, glm::dvec4(middle, 1.0)), 0.25 * depth);
  const double across = width * glm::length(glm::dvec3(glm::row(clipFromMC, 0)));
  const double upwards = height * glm::length(glm::dvec3(glm::row(clipFromMC, 1)));
  return 0.5 * std::max(across, upwards) / w;
}

void LargeFaces::find(const SEDGeometry& geometry, const ContributingFaces& contributing, double pixels,
                      double lineReach)
{
  // A face of which two edges are lines covers twice as much as its thin triangles do from about this length
  // on; to ask it costs nine vertices.
  const double reach = lineReach + pixelDiagonal;
  const double shortest = std::max(128.0, 6.0 * reach * reach);
  const double length = std::max(shortest / pixels, std::ldexp(1.0, least));
  const int found = std::min(std::ilogb(length), most);
  if (this->exponent != found)
  {
    this->exponent = found;
    // The shader's single precision must find none that is not in the list.
    this->runs = contributing.findLongFrom(geometry, 0.999 * std::ldexp(1.0, found));
  }
}

void LargeFaces::clear()
{
  this->exponent.reset();
  this->runs.clear();
}

float LargeFaces::getLength() const
{
  return this->exponent ? std::ldexp(1.0f, *this->exponent) : std::numeric_limits<float>::max();
}

} // namespace shadow
