#include "Camera.h"

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace shadow::examples
{
namespace
{

// From the subject to the eye: right, up and front of it.
constexpr Vector3 TOWARDS_EYE = {0.42, 0.52, 1.0};

constexpr double VIEW_ANGLE = 30.0;

// Room around the subject.
constexpr double MARGIN = 1.08;

// How far from the models' centre a shadow counts, in diagonals: one of a low light would shrink all else to
// a dot.
constexpr double LONGEST_SHADOW = 1.1;

Vector3 subtract(const Vector3& a, const Vector3& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// Adds where a light throws a corner of the models on the floor.
void addShadow(std::vector<Vector3>& points, const Vector3& corner, const LightOption& light,
               const CameraSubject& subject, const Vector3& centre)
{
  const Vector3 ray =
      light.kind == LightOption::Kind::Directional ? light.direction : subtract(corner, light.position);
  const double height = corner[1] - *subject.floorHeight;
  if (ray[1] >= 0.0 || height <= 0.0)
  {
    return;
  }
  const double reach = height / -ray[1];
  Vector3 offset = {corner[0] + reach * ray[0] - centre[0], 0.0, corner[2] + reach * ray[2] - centre[2]};
  const double distance = std::hypot(offset[0], offset[2]);
  const double longest = LONGEST_SHADOW * subject.models.GetDiagonalLength();
  const double scale = distance > longest ? longest / distance : 1.0;
  points.push_back({centre[0] + scale * offset[0], *subject.floorHeight, centre[2] + scale * offset[2]});
}

std::vector<Vector3> pointsInView(const CameraSubject& subject)
{
  std::vector<Vector3> points;
  Vector3 centre;
  subject.models.GetCenter(centre.data());
  for (int index = 0; index < 8; ++index)
  {
    Vector3 corner;
    subject.models.GetCorner(index, corner.data());
    points.push_back(corner);
    for (const LightOption& light : subject.lights)
    {
      if (subject.floorHeight)
      {
        addShadow(points, corner, light, subject, centre);
      }
    }
  }
  return points;
}

// The least distance of the eye from `centre` at which all points are inside the view.
double fittingDistance(const std::vector<Vector3>& points, const Vector3& centre, const Vector3& towardsEye,
                       double aspect)
{
  Vector3 right, up;
  const Vector3 worldUp = {0.0, 1.0, 0.0};
  vtkMath::Cross(worldUp.data(), towardsEye.data(), right.data());
  vtkMath::Normalize(right.data());
  vtkMath::Cross(towardsEye.data(), right.data(), up.data());
  const double tangentY = std::tan(vtkMath::RadiansFromDegrees(0.5 * VIEW_ANGLE)) / MARGIN;
  const double tangentX = tangentY * aspect;
  double distance = 0.0;
  for (const Vector3& point : points)
  {
    const Vector3 offset = subtract(point, centre);
    const double towards = vtkMath::Dot(offset.data(), towardsEye.data());
    const double x = std::abs(vtkMath::Dot(offset.data(), right.data()));
    const double y = std::abs(vtkMath::Dot(offset.data(), up.data()));
    distance = std::max({distance, towards + x / tangentX, towards + y / tangentY});
  }
  return distance;
}

} // namespace

CameraOption chooseCamera(const CameraSubject& subject)
{
  const std::vector<Vector3> points = pointsInView(subject);
  vtkBoundingBox box;
  for (const Vector3& point : points)
  {
    box.AddPoint(point[0], point[1], point[2]);
  }
  CameraOption camera;
  box.GetCenter(camera.focalPoint.data());
  Vector3 towardsEye = TOWARDS_EYE;
  vtkMath::Normalize(towardsEye.data());
  const double distance = fittingDistance(points, camera.focalPoint, towardsEye, subject.aspect);
  for (int i = 0; i < 3; ++i)
  {
    camera.position[i] = camera.focalPoint[i] + distance * towardsEye[i];
  }
  camera.viewAngle = VIEW_ANGLE;
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
