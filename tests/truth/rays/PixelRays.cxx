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

glm::dvec4 PixelRays::toClip(const glm::dvec3& point) const
{
  const glm::dvec4 p(point, 1.0);
  return {glm::dot(this->rowX, p), glm::dot(this->rowY, p), glm::dot(this->nearPlane, p),
          glm::dot(this->rowW, p)};
}

glm::dvec2 PixelRays::toPixels(const glm::dvec4& clip) const
{
  return (glm::dvec2(clip) / clip.w + 1.0) / this->ndcPerPixel;
}

glm::dvec3 PixelRays::atHeight(const Ray& ray, double height) const
{
  return ray.origin + height / glm::dot(glm::dvec3(this->nearPlane), ray.direction) * ray.direction;
}

glm::dvec4 PixelRays::eye() const
{
  // The one point that has x = y = w = 0.
  const glm::dvec3 x(this->rowX), y(this->rowY), w(this->rowW);
  const glm::dvec3 position =
      -(this->rowX.w * glm::cross(y, w) + this->rowY.w * glm::cross(w, x) + this->rowW.w * glm::cross(x, y));
  const double weight = glm::dot(glm::cross(x, y), w);
  if (weight != 0.0)
  {
    return {position / weight, 1.0};
  }
  const double outwards = glm::dot(glm::dvec3(this->nearPlane), position) < 0.0 ? 1.0 : -1.0;
  return {outwards * glm::normalize(position), 0.0};
}

} // namespace shadow::truth
