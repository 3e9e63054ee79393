#include "Lights.h"

#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace shadow::examples
{
namespace
{

// From this half angle on vtkLight shines in all directions.
constexpr double UNLIMITED_CONE = 90.0;

// Where the chosen light stands, from the models' centre, in half diagonals.
constexpr Vector3 CHOSEN = {-1.4, 2.6, 1.5};

Vector3 subtract(const Vector3& a, const Vector3& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector3 cornerOf(const vtkBoundingBox& box, int index)
{
  Vector3 corner;
  box.GetCorner(index, corner.data());
  return corner;
}

double dot(const Vector3& a, const Vector3& b)
{
  return vtkMath::Dot(a.data(), b.data());
}

double cosineTo(const Vector3& axis, const Vector3& point)
{
  const double distance = vtkMath::Norm(point.data());
  return distance > 0.0 ? dot(axis, point) / distance : 1.0;
}

// The largest cosine between `axis` and any point of the segment a b, all seen from the origin. Along the
// segment axis.p/|p| has one stationary point, where the derivative's numerator, linear in the parameter, is
// zero.
double largestCosine(const Vector3& axis, const Vector3& a, const Vector3& b)
{
  const Vector3 along = subtract(b, a);
  const double axisA = dot(axis, a), axisAlong = dot(axis, along);
  const double aa = dot(a, a), aAlong = dot(a, along), alongAlong = dot(along, along);
  double best = std::max(cosineTo(axis, a), cosineTo(axis, b));
  const double denominator = axisA * alongAlong - axisAlong * aAlong;
  const double t = denominator != 0.0 ? (axisAlong * aa - axisA * aAlong) / denominator : -1.0;
  if (t > 0.0 && t < 1.0)
  {
    best = std::max(best, cosineTo(axis, {a[0] + t * along[0], a[1] + t * along[1], a[2] + t * along[2]}));
  }
  return best;
}

bool rayMeets(const vtkBoundingBox& box, const Vector3& origin, const Vector3& direction)
{
  double enter = 0.0, leave = VTK_DOUBLE_MAX;
  for (int i = 0; i < 3; ++i)
  {
    const double low = box.GetMinPoint()[i] - origin[i], high = box.GetMaxPoint()[i] - origin[i];
    if (direction[i] == 0.0)
    {
      if (low > 0.0 || high < 0.0)
      {
        return false;
      }
      continue;
    }
    enter = std::max(enter, std::min(low / direction[i], high / direction[i]));
    leave = std::min(leave, std::max(low / direction[i], high / direction[i]));
  }
  return enter <= leave;
}

} // namespace

LightOption chooseLight(const vtkBoundingBox& models)
{
  LightOption light;
  const double half = 0.5 * models.GetDiagonalLength();
  double centre[3];
  models.GetCenter(centre);
  for (int i = 0; i < 3; ++i)
  {
    light.position[i] = centre[i] + half * CHOSEN[i];
  }
  return light;
}

// Seen from outside, a box covers a convex region of the sky. The point of it that is nearest to the axis is
// the axis itself or lies on the region's rim, which is made of the box's edges.
bool canReach(const LightOption& light, const vtkBoundingBox& box)
{
  if (light.kind != LightOption::Kind::Spot || light.coneAngle >= UNLIMITED_CONE ||
      box.ContainsPoint(light.position.data()))
  {
    return true;
  }
  Vector3 axis = subtract(light.target, light.position);
  vtkMath::Normalize(axis.data());
  if (rayMeets(box, light.position, axis))
  {
    return true;
  }
  const double rim = std::cos(vtkMath::RadiansFromDegrees(light.coneAngle));
  for (int corner = 0; corner < 8; ++corner)
  {
    for (int bit = 1; bit < 8; bit *= 2)
    {
      const Vector3 a = subtract(cornerOf(box, corner), light.position);
      const Vector3 b = subtract(cornerOf(box, corner ^ bit), light.position);
      if (largestCosine(axis, a, b) >= rim)
      {
        return true;
      }
    }
  }
  return false;
}

LightOption turnLight(const LightOption& light, const Vector3& centre, double degrees)
{
  const double sine = std::sin(vtkMath::RadiansFromDegrees(degrees));
  const double cosine = std::cos(vtkMath::RadiansFromDegrees(degrees));
  const auto turn = [&](const Vector3& v) -> Vector3 {
    return {cosine * v[0] + sine * v[2], v[1], cosine * v[2] - sine * v[0]};
  };
  const auto turnPoint = [&](const Vector3& point) -> Vector3
  {
    const Vector3 turned = turn(subtract(point, centre));
    return {turned[0] + centre[0], turned[1] + centre[1], turned[2] + centre[2]};
  };
  LightOption result = light;
  result.position = turnPoint(light.position);
  result.target = turnPoint(light.target);
  result.direction = turn(light.direction);
  return result;
}

void setLights(vtkRenderer* renderer, const std::vector<LightOption>& lights)
{
  renderer->AutomaticLightCreationOff();
  renderer->RemoveAllLights();
  const double intensity = std::min(1.0, 1.2 / static_cast<double>(lights.size()));
  for (const LightOption& option : lights)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetIntensity(intensity);
    const Vector3& from = option.position;
    const Vector3& to = option.target;
    switch (option.kind)
    {
    case LightOption::Kind::Directional:
      // vtkLight shines from its position to its focal point
      light->SetPositional(false);
      light->SetPosition(-option.direction[0], -option.direction[1], -option.direction[2]);
      light->SetFocalPoint(0.0, 0.0, 0.0);
      break;
    case LightOption::Kind::Point:
      light->SetPositional(true);
      light->SetConeAngle(180.0);
      light->SetPosition(from[0], from[1], from[2]);
      light->SetFocalPoint(from[0], from[1] - 1.0, from[2]);
      break;
    case LightOption::Kind::Spot:
      light->SetPositional(true);
      light->SetConeAngle(option.coneAngle);
      light->SetPosition(from[0], from[1], from[2]);
      light->SetFocalPoint(to[0], to[1], to[2]);
      break;
    }
    renderer->AddLight(light);
  }
}

} // namespace shadow::examples
