#include "PixelRays.h"

namespace shadow::truth
{

namespace
{

/// Row of the matrix as a plane, moved to the local origin. At world offsets of 1e7 the two terms of the
/// constant nearly cancel, hence long double.
glm::dvec4 localRow(const glm::dmat4& matrix, int row, const glm::dvec3& originWC)
{
  long double constant = matrix[3][row];
  for (int axis = 0; axis < 3; ++axis)
  {
    constant += static_cast<long double>(matrix[axis][row]) * originWC[axis];
  }
  return {matrix[0][row], matrix[1][row], matrix[2][row], static_cast<double>(constant)};
}

} // namespace

PixelRays::PixelRays(const View& view, const glm::dvec3& originWC)
    : rowX(localRow(view.clipFromWC, 0, originWC)), rowY(localRow(view.clipFromWC, 1, originWC)),
      rowW(localRow(view.clipFromWC, 3, originWC)), nearPlane(localRow(view.clipFromWC, 2, originWC) + rowW),
      ndcPerPixel(2.0 / view.width, 2.0 / view.height)
{
}

Ray PixelRays::through(double x, double y) const
{
  const glm::dvec4 planeX = this->rowX - (x * this->ndcPerPixel.x - 1.0) * this->rowW;
  const glm::dvec4 planeY = this->rowY - (y * this->ndcPerPixel.y - 1.0) * this->rowW;
  const glm::dvec3 normalX(planeX), normalY(planeY), normalNear(this->nearPlane);

  // Where the three planes meet; the line runs along the cross product of the first two.
  const glm::dvec3 line = glm::cross(normalX, normalY);
  const double determinant = glm::dot(line, normalNear);
  Ray ray;
  ray.origin = -(planeX.w * glm::cross(normalY, normalNear) + planeY.w * glm::cross(normalNear, normalX) +
                 this->nearPlane.w * line) /
               determinant;

  // Into the frustum is where the near plane's value grows. The signed area of a triangle on the screen is
  // line . normal up to a positive factor, which makes the line the direction fronts turn to.
  const double inwards = determinant > 0.0 ? 1.0 : -1.0;
  ray.direction = glm::normalize(line) * inwards;
  ray.frontSign = inwards;
  return ray;
}

} // namespace shadow::truth
