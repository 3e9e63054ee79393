#include "ActorTraits.h"

#include <algorithm>

#include <vtkActor.h>
#include <vtkImageActor.h>
#include <vtkMapper.h>
#include <vtkPlaneCollection.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkTexture.h>

namespace shadow
{

FaceCulling faceCullingOf(vtkActor* actor)
{
  // Where both are set, VTK culls the back.
  const bool front = actor->GetProperty()->GetFrontfaceCulling() != 0;
  return actor->GetProperty()->GetBackfaceCulling() != 0 ? FaceCulling::Back
                                                         : (front ? FaceCulling::Front : FaceCulling::None);
}

bool isBlendedAsOpaque(vtkProp* prop)
{
  if (auto* image = vtkImageActor::SafeDownCast(prop))
  {
    return image->GetForceOpaque();
  }
  auto* actor = vtkActor::SafeDownCast(prop);
  vtkMapper* mapper = actor != nullptr ? actor->GetMapper() : nullptr;
  if (mapper == nullptr)
  {
    return false;
  }
  if (mapper->IsA("vtkPointGaussianMapper"))
  {
    return true;
  }
  vtkTexture* texture = actor->GetTexture();
  return actor->GetForceOpaque() &&
         (actor->GetProperty()->GetOpacity() < 1.0 || mapper->IsA("vtkGlyph3DMapper") ||
          mapper->HasTranslucentPolygonalGeometry() || (texture != nullptr && texture->IsTranslucent() != 0));
}

bool letsThrough(vtkActor* actor)
{
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  // VTK leaves out what a texture makes wholly transparent, and takes the actor for opaque all the same.
  // Edges are drawn wider than the triangles they belong to: those of a back reach over the rim.
  return actor->GetTexture() != nullptr || actor->GetProperty()->GetNumberOfTextures() > 0 ||
         actor->GetForceOpaque() || actor->GetProperty()->GetEdgeVisibility() != 0 ||
         shaders->HasVertexShaderCode() || shaders->HasFragmentShaderCode() || shaders->HasGeometryShaderCode() ||
         shaders->GetNumberOfShaderReplacements() > 0;
}

bool mayBeOpaque(vtkProp* prop)
{
  return prop->IsA("vtkActor2D") == 0 && prop->IsA("vtkVolume") == 0 && prop->HasOpaqueGeometry() != 0;
}

bool drawsLines(vtkActor* actor)
{
  auto* data = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  // What a glyph mapper is given are places, not cells to draw.
  const bool hasOtherCells = data != nullptr && !actor->GetMapper()->IsA("vtkGlyph3DMapper") &&
                             data->GetNumberOfVerts() + data->GetNumberOfLines() > 0;
  return hasOtherCells || actor->GetProperty()->GetRepresentation() != VTK_SURFACE ||
         actor->GetProperty()->GetEdgeVisibility() != 0;
}

bool hasLinesOrPoints(vtkActor* actor, const std::vector<vtkPolyData*>& drawn)
{
  vtkPlaneCollection* planes = actor->GetMapper()->GetClippingPlanes();
  // Of clipped data only polygons are handed out.
  return actor->GetProperty()->GetVertexVisibility() != 0 ||
         (planes != nullptr && planes->GetNumberOfItems() > 0) ||
         std::any_of(drawn.begin(), drawn.end(), [](vtkPolyData* polyData)
                     { return polyData->GetNumberOfVerts() + polyData->GetNumberOfLines() > 0; });
}

bool hasTubesOrSpheres(vtkActor* actor, const std::vector<vtkPolyData*>& drawn)
{
  vtkProperty* property = actor->GetProperty();
  return std::any_of(drawn.begin(), drawn.end(),
                     [&](vtkPolyData* polyData)
                     {
                       return (property->GetRenderLinesAsTubes() && polyData->GetNumberOfLines() > 0) ||
                              (property->GetRenderPointsAsSpheres() && polyData->GetNumberOfVerts() > 0);
                     });
}

} // namespace shadow
