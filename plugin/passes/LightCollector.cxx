#include "LightCollector.h"

#include <string>

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderer.h>
#include <vtkTransform.h>

namespace shadow
{

namespace
{

// Where VTK's shaders see a camera light: the renderer's user light transform moves it in view space.
glm::dvec4 applyUserLightTransform(vtkRenderer* renderer, const glm::dvec4& worldPosition)
{
  auto* glRenderer = vtkOpenGLRenderer::SafeDownCast(renderer);
  vtkTransform* user = glRenderer != nullptr ? glRenderer->GetUserLightTransform() : nullptr;
  if (user == nullptr)
  {
    return worldPosition;
  }
  vtkMatrix4x4* view = renderer->GetActiveCamera()->GetModelViewTransformMatrix();
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(view, inverse);
  double position[4] = {worldPosition.x, worldPosition.y, worldPosition.z, worldPosition.w};
  view->MultiplyPoint(position, position);
  user->GetMatrix()->MultiplyPoint(position, position);
  inverse->MultiplyPoint(position, position);
  return {position[0], position[1], position[2], position[3]};
}

glm::dvec4 homogeneousPosition(vtkRenderer* renderer, vtkLight* light)
{
  double position[3];
  double focalPoint[3];
  light->GetTransformedPosition(position);
  light->GetTransformedFocalPoint(focalPoint);
  glm::dvec4 result(position[0], position[1], position[2], 1.0);
  if (light->GetPositional() == 0)
  {
    result -= glm::dvec4(focalPoint[0], focalPoint[1], focalPoint[2], 1.0);
    result.w = 0.0;
  }
  return light->LightTypeIsSceneLight() != 0 ? result : applyUserLightTransform(renderer, result);
}

// Shaders see lights in single precision, and multiply them.
bool isUsable(const glm::dvec4& position)
{
  const double length = glm::length(glm::dvec3(position));
  return length < 1e30 && (position.w != 0.0 || length > 0.0);
}

} // namespace

LightList collectLights(vtkRenderer* renderer)
{
  LightList list;
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    if (light->GetSwitch() == 0)
    {
      continue;
    }
    const int index = static_cast<int>(list.attenuation.size());
    const std::string name = "light " + std::to_string(index);
    list.attenuation.push_back(0.0f);
    if (light->LightTypeIsHeadlight() != 0)
    {
      continue;
    }
    const glm::dvec4 position = homogeneousPosition(renderer, light);
    if (index >= maximumLights)
    {
      list.messages.push_back(name + " casts no shadows: " + std::to_string(maximumLights) + " lights can");
    }
    else if (!isUsable(position))
    {
      list.messages.push_back(name + " casts no shadows: it has no direction, or no finite position");
    }
    else
    {
      list.attenuation.back() = light->GetShadowAttenuation();
      list.lights.push_back(Light{index, position});
    }
  }
  return list;
}

} // namespace shadow
