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
constexpr double least = 1e-18;
constexpr double most = 1e18;
constexpr double pixelDiagonal = 1.4142136;

/// Pixels from which on a face is asked whether it is large.
///
/// An equilateral triangle with edges of a, scaled about its incentre until all within R of it is covered, is
/// 3 sqrt(3) (a / sqrt(12) + R)^2 large; the thin triangles along two of its edges are 8 R (a + 2 R). The
/// first is twice the second at a = 32 R. Of another shape it is twice as large from another length on, of
/// half a square at 38 R: the shader compares face by face, this only spares it most of those that cannot be
/// large.
/// @param reach  R
double findShortest(double reach)
{
  // To ask costs nine vertices, so small ones are not worth it.
  return std::max(128.0, 32.0 * reach);
}

} // namespace

double measurePixels(const SEDGeometry& geometry, const glm::dmat4& clipFromMC, int width, int height)
{
  const glm::dvec3 middle = 0.5 * (geometry.getLowerBound() + geometry.getUpperBound());
  const glm::dvec3 halfSize = geometry.getUpperBound() - middle;
  const glm::dvec4 toW = glm::row(clipFromMC, 3);
  const double depth = glm::dot(glm::abs(glm::dvec3(toW)), halfSize);
  const double middleW = glm::dot(toW, glm::dvec4(middle, 1.0));
  if (middleW + depth <= 0.0)
  {
    return 0.0;
  }
  const double w = std::max(middleW, 0.25 * depth);
  const double across = width * glm::length(glm::dvec3(glm::row(clipFromMC, 0)));
  const double upwards = height * glm::length(glm::dvec3(glm::row(clipFromMC, 1)));
  return 0.5 * std::max(across, upwards) / w;
}

void LargeFaces::find(const SEDGeometry& geometry, const ContributingFaces& contributing, double pixels,
                      double lineReach)
{
  const double wanted = std::clamp(findShortest(lineReach + pixelDiagonal) / pixels, least, most);
  // Faces longer than wanted are in the list of any shorter length, of which fewer are in vain the longer it
  // is.
  if (!this->length || wanted < *this->length || wanted > 2.0 * *this->length)
  {
    this->length = static_cast<float>(std::clamp(wanted / std::sqrt(2.0), least, most));
    // The shader's single precision must find none that is not in the list.
    this->runs = contributing.findLongFrom(geometry, 0.999 * *this->length);
  }
}

void LargeFaces::clear()
{
  this->length.reset();
  this->runs.clear();
}

float LargeFaces::getLength() const
{
  return this->length.value_or(std::numeric_limits<float>::max());
}

} // namespace shadow
