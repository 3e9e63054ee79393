#include "Camera.h"

#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace shadow::examples
{
namespace
{

// From the subject to the eye: right, up and front of it.
constexpr Vector3 TOWARDS_EYE = {0.42, 0.52, 1.0};

constexpr double VIEW_ANGLE = 30.0;

// Room around the subject, as a factor.
constexpr double MARGIN = 1.08;

// How far from the models' centre a shadow counts, in diagonals: one of a low light would shrink all else to
// a dot.
constexpr double LONGEST_SHADOW = 1.6;

Vector3 subtract(const Vector3& a, const Vector3& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

struct Basis
{
  Vector3 right, up, towardsEye; ///< unit vectors
};

Basis viewBasis()
{
  Basis basis;
  basis.towardsEye = TOWARDS_EYE;
  vtkMath::Normalize(basis.towardsEye.data());
  const Vector3 worldUp = {0.0, 1.0, 0.0};
  vtkMath::Cross(worldUp.data(), basis.towardsEye.data(), basis.right.data());
  vtkMath::Normalize(basis.right.data());
  vtkMath::Cross(basis.towardsEye.data(), basis.right.data(), basis.up.data());
  return basis;
}

// Where a light throws a point of the models on the floor, drawn in to `longest` from their centre.
std::optional<Vector3> shadowOf(const Vector3& point, const LightOption& light, double floorHeight,
                                const Vector3& centre, double longest)
{
  const bool directional = light.kind == LightOption::Kind::Directional;
  const Vector3 ray = directional ? light.direction : subtract(point, light.position);
  const double height = point[1] - floorHeight;
  if (ray[1] >= 0.0 || height <= 0.0)
  {
    return std::nullopt;
  }
  const double reach = height / -ray[1];
  const Vector3 offset = {point[0] + reach * ray[0] - centre[0], 0.0, point[2] + reach * ray[2] - centre[2]};
  const double distance = std::hypot(offset[0], offset[2]);
  const double scale = distance > longest ? longest / distance : 1.0;
  return Vector3{centre[0] + scale * offset[0], floorHeight, centre[2] + scale * offset[2]};
}

std::vector<Vector3> pointsInView(const CameraSubject& subject)
{
  vtkBoundingBox box;
  for (const Vector3& point : subject.points)
  {
    box.AddPoint(point[0], point[1], point[2]);
  }
  Vector3 centre;
  box.GetCenter(centre.data());
  std::vector<Vector3> points = subject.points;
  for (std::size_t i = 0; subject.floorHeight && i < subject.points.size() * subject.lights.size(); ++i)
  {
    const Vector3& point = subject.points[i / subject.lights.size()];
    const LightOption& light = subject.lights[i % subject.lights.size()];
    const auto shadow =
        shadowOf(point, light, *subject.floorHeight, centre, LONGEST_SHADOW * box.GetDiagonalLength());
    if (shadow)
    {
      points.push_back(*shadow);
    }
  }
  return points;
}

// The points as the view sees them: right, up and towards the eye.
std::vector<Vector3> inView(const std::vector<Vector3>& points, const Basis& basis)
{
  std::vector<Vector3> result;
  result.reserve(points.size());
  for (const Vector3& point : points)
  {
    result.push_back({vtkMath::Dot(point.data(), basis.right.data()),
                      vtkMath::Dot(point.data(), basis.up.data()),
                      vtkMath::Dot(point.data(), basis.towardsEye.data())});
  }
  return result;
}

// The eye, in the view's own axes, that has all points inside its pyramid and is nearest to them. Each side
// of the pyramid touches the outermost point in its direction: for the right one, x + z tangent is the same
// for the eye and that point.
Vector3 fittingEye(const std::vector<Vector3>& points, double tangentX, double tangentY)
{
  constexpr double none = -std::numeric_limits<double>::max();
  double right = none, left = none, top = none, bottom = none;
  for (const Vector3& p : points)
  {
    right = std::max(right, p[0] + p[2] * tangentX);
    left = std::max(left, -p[0] + p[2] * tangentX);
    top = std::max(top, p[1] + p[2] * tangentY);
    bottom = std::max(bottom, -p[1] + p[2] * tangentY);
  }
  const double z = std::max((right + left) / (2.0 * tangentX), (top + bottom) / (2.0 * tangentY));
  return {0.5 * (right - left), 0.5 * (top - bottom), z};
}

} // namespace

CameraOption chooseCamera(const CameraSubject& subject)
{
  const Basis basis = viewBasis();
  const std::vector<Vector3> points = inView(pointsInView(subject), basis);
  const double tangent = std::tan(vtkMath::RadiansFromDegrees(0.5 * VIEW_ANGLE)) / MARGIN;
  const Vector3 eye = fittingEye(points, tangent * subject.aspect, tangent);
  double nearest = points.front()[2];
  double farthest = nearest;
  for (const Vector3& point : points)
  {
    nearest = std::max(nearest, point[2]);
    farthest = std::min(farthest, point[2]);
  }
  const double focalDistance = eye[2] - 0.5 * (nearest + farthest);

  CameraOption camera;
  camera.viewAngle = VIEW_ANGLE;
  for (int i = 0; i < 3; ++i)
  {
    camera.position[i] = eye[0] * basis.right[i] + eye[1] * basis.up[i] + eye[2] * basis.towardsEye[i];
    camera.focalPoint[i] = camera.position[i] - focalDistance * basis.towardsEye[i];
  }
  return camera;
}

void setCamera(vtkRenderer* renderer, const CameraOption& option, const std::optional<double>& parallelScale)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(option.position.data());
  camera->SetFocalPoint(option.focalPoint.data());
  camera->SetViewUp(option.viewUp.data());
  camera->SetViewAngle(option.viewAngle);
  if (parallelScale)
  {
    camera->ParallelProjectionOn();
    camera->SetParallelScale(*parallelScale);
  }
  renderer->ResetCameraClippingRange();
}

} // namespace shadow::examples
