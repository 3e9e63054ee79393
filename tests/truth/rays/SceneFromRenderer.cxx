#include "SceneFromRenderer.h"

#include <vtkActor.h>
#include <vtkAssemblyNode.h>
#include <vtkAssemblyPath.h>
#include <vtkCamera.h>
#include <vtkCollection.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkPropAssembly.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "WorldTriangles.h"

namespace shadow::truth
{

namespace
{

/// What VTK draws of a path: an invisible vtkPropAssembly hides its parts, an invisible vtkAssembly inside
/// another one does not.
bool isDrawn(vtkAssemblyPath* path)
{
  vtkCollectionSimpleIterator cursor;
  path->InitTraversal(cursor);
  vtkProp* leaf = path->GetLastNode()->GetViewProp();
  while (vtkAssemblyNode* node = path->GetNextNode(cursor))
  {
    vtkProp* prop = node->GetViewProp();
    if (!prop->GetVisibility() && (prop == leaf || vtkPropAssembly::SafeDownCast(prop)))
    {
      return false;
    }
  }
  return true;
}

bool castsAlong(vtkAssemblyPath* path, const CastsShadow& casts)
{
  vtkCollectionSimpleIterator cursor;
  path->InitTraversal(cursor);
  while (vtkAssemblyNode* node = path->GetNextNode(cursor))
  {
    if (casts && !casts(node->GetViewProp()))
    {
      return false;
    }
  }
  return true;
}

void appendPath(vtkAssemblyPath* path, const CastsShadow& casts, Scene& scene)
{
  auto* actor = vtkActor::SafeDownCast(path->GetLastNode()->GetViewProp());
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  if (!mapper || !isDrawn(path) || actor->IsA("vtkSkybox") || mapper->GetNumberOfInputConnections(0) == 0)
  {
    return;
  }
  mapper->Update();
  vtkProperty* property = actor->GetProperty();
  if (property->GetRepresentation() != VTK_SURFACE || !actor->HasOpaqueGeometry())
  {
    return;
  }
  Triangle style;
  style.casts = castsAlong(path, casts);
  style.hideFront = property->GetFrontfaceCulling() != 0;
  style.hideBack = property->GetBackfaceCulling() != 0;
  vtkMatrix4x4* matrix = path->GetLastNode()->GetMatrix();
  appendWorldTriangles(mapper, matrix ? toGlm(matrix) : glm::dmat4(1.0), style, scene);
}

View viewOf(vtkCamera* camera, double aspect, int width, int height)
{
  return {toGlm(camera->GetCompositeProjectionTransformMatrix(aspect, -1, 1)), width, height};
}

} // namespace

Scene sceneFromRenderer(vtkRenderer* renderer, const CastsShadow& casts)
{
  Scene scene;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator cursor;
  props->InitTraversal(cursor);
  while (vtkProp* prop = props->GetNextProp(cursor))
  {
    if (!prop->GetVisibility())
    {
      continue;
    }
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetNextPath())
    {
      appendPath(path, casts, scene);
    }
  }
  return scene;
}

View viewFromCamera(vtkCamera* camera, int width, int height)
{
  return viewOf(camera, static_cast<double>(width) / height, width, height);
}

View viewFromRenderer(vtkRenderer* renderer)
{
  int width = 0;
  int height = 0;
  renderer->GetTiledSize(&width, &height);
  return viewOf(renderer->GetActiveCamera(), renderer->GetTiledAspectRatio(), width, height);
}

std::vector<RendererLight> lightsFromRenderer(vtkRenderer* renderer)
{
  std::vector<RendererLight> result;
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator cursor;
  lights->InitTraversal(cursor);
  while (vtkLight* light = lights->GetNextLight(cursor))
  {
    if (!light->GetSwitch())
    {
      continue;
    }
    glm::dvec3 position, focus;
    light->GetTransformedPosition(&position[0]);
    light->GetTransformedFocalPoint(&focus[0]);
    const glm::dvec3 towards = position - focus;
    const double distance = glm::length(towards);
    RendererLight entry;
    entry.light.positionWC = light->GetPositional() ? glm::dvec4(position, 1.0)
                             : distance > 0.0       ? glm::dvec4(towards / distance, 0.0)
                                                    : glm::dvec4(0.0);
    entry.casts = !light->LightTypeIsHeadlight();
    entry.source = light;
    result.push_back(entry);
  }
  return result;
}

} // namespace shadow::truth
