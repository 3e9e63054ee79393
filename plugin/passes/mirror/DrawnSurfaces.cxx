#include "DrawnSurfaces.h"

#include <algorithm>

#include <glm/gtc/type_ptr.hpp>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkClipPolyData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataObjectTree.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkDataSet.h>
#include <vtkMapper.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkProperty.h>
#include <vtkScalarsToColors.h>
#include <vtkTexture.h>

#include "../../vtkShadowCompat.h"

#include <vtkCompositeDataDisplayAttributes.h>
#if VTKSHADOW_VTK_AT_LEAST(9, 3)
#include <vtkCompositePolyDataMapper.h>
#else
#include <vtkCompositePolyDataMapper2.h>
#endif

#include "MeshImport.h"
#include "SweepUnused.h"

namespace shadow
{

namespace
{

/// Visible opaque leaves of composite data. A block without a visibility or opacity of its own has its parent's,
/// the outermost the actor's opacity.
class OpaqueBlocks
{
public:
  explicit OpaqueBlocks(vtkActor* actor)
      : composite(VTKSHADOW_COMPOSITE_MAPPER::SafeDownCast(actor->GetMapper())),
        attributes(composite != nullptr ? composite->GetCompositeDataDisplayAttributes() : nullptr),
        opaqueTexture(actor->GetTexture() == nullptr || actor->GetTexture()->IsTranslucent() == 0)
  {
    this->collect(actor->GetMapper()->GetInputDataObject(0, 0), true, actor->GetProperty()->GetOpacity() >= 1.0);
  }

  std::vector<vtkPolyData*> take() { return std::move(this->leaves); }

private:
  void collect(vtkDataObject* block, bool visible, bool opaque)
  {
    if (this->attributes != nullptr && this->attributes->HasBlockVisibility(block))
    {
      visible = this->attributes->GetBlockVisibility(block);
    }
    if (this->attributes != nullptr && this->attributes->HasBlockOpacity(block))
    {
      opaque = this->attributes->GetBlockOpacity(block) >= 1.0;
    }
    if (auto* tree = vtkDataObjectTree::SafeDownCast(block))
    {
      const auto children = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
      children->TraverseSubTreeOff();
      children->VisitOnlyLeavesOff();
      for (children->InitTraversal(); !children->IsDoneWithTraversal(); children->GoToNextItem())
      {
        this->collect(children->GetCurrentDataObject(), visible, opaque);
      }
    }
    else if (auto* polyData = vtkPolyData::SafeDownCast(block); polyData != nullptr && visible && opaque)
    {
      if (this->opaqueTexture && this->hasOpaqueColours(polyData))
      {
        this->leaves.push_back(polyData);
      }
    }
  }

  /// A mapper without block attributes asks the actor only.
  bool hasOpaqueColours(vtkPolyData* leaf) const
  {
    vtkMapper* mapper = this->composite;
    if (mapper == nullptr || !mapper->GetScalarVisibility())
    {
      return true;
    }
    int cellFlag = 0;
    vtkDataArray* scalars = vtkAbstractMapper::GetScalars(leaf, mapper->GetScalarMode(), mapper->GetArrayAccessMode(),
                                                          mapper->GetArrayId(), mapper->GetArrayName(), cellFlag);
    vtkScalarsToColors* colours = mapper->GetLookupTable();
    colours->Build();
    return colours->IsOpaque(scalars, mapper->GetColorMode(), mapper->GetArrayComponent()) != 0;
  }

  VTKSHADOW_COMPOSITE_MAPPER* composite;
  vtkCompositeDataDisplayAttributes* attributes;
  bool opaqueTexture;
  std::vector<vtkPolyData*> leaves;
};

// The triangles that VTK draws. A clipper would cut polygons that are concave or not flat in its own way.
vtkSmartPointer<vtkPolyData> fan(vtkPolyData* input)
{
  const auto fanned = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkCellArray> triangles;
  for (const auto& triangle : importTriangles(input).triangles)
  {
    triangles->InsertNextCell({static_cast<vtkIdType>(triangle[0]), static_cast<vtkIdType>(triangle[1]),
                               static_cast<vtkIdType>(triangle[2])});
  }
  fanned->SetPoints(input->GetPoints());
  fanned->SetPolys(triangles);
  return fanned;
}

} // namespace

bool DrawnSurfaces::areKnown(vtkMapper* mapper)
{
  if (mapper->IsA("vtkGlyph3DMapper") || mapper->IsA("vtkPointGaussianMapper") ||
      mapper->IsA("vtkOpenGLSphereMapper") || mapper->IsA("vtkOpenGLStickMapper"))
  {
    return false;
  }
  return mapper->IsA("vtkPolyDataMapper") || mapper->IsA("vtkDataSetMapper") ||
         mapper->IsA("vtkCompositePolyDataMapper");
}

std::vector<vtkPolyData*> DrawnSurfaces::collect(vtkActor* actor, const PropPath& path,
                                                 const glm::dmat4& modelToWorld)
{
  vtkMapper* mapper = actor->GetMapper();
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  std::vector<vtkPolyData*> data;
  if (auto* polyData = vtkPolyData::SafeDownCast(input))
  {
    data.push_back(polyData);
  }
  else if (vtkCompositeDataSet::SafeDownCast(input) != nullptr)
  {
    data = OpaqueBlocks(actor).take();
  }
  else if (vtkDataSet::SafeDownCast(input) != nullptr)
  {
    data.push_back(this->extractSurface(mapper, input));
  }
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  if (planes != nullptr && planes->GetNumberOfItems() > 0)
  {
    std::transform(data.begin(), data.end(), data.begin(),
                   [&](vtkPolyData* polyData) { return this->clip(polyData, planes, path, modelToWorld); });
  }
  return data;
}

// As a vtkDataSetMapper does; its own filter is only there, and only up to date, once it has rendered.
vtkPolyData* DrawnSurfaces::extractSurface(vtkMapper* mapper, vtkDataObject* input)
{
  Surface& surface = this->surfaces[mapper];
  surface.used = true;
  if (surface.filter->GetInputDataObject(0, 0) != input)
  {
    surface.filter->SetInputData(input);
  }
  surface.filter->Update();
  return surface.filter->GetOutput();
}

// VTK clips in the shader, by planes in world space; a shadow needs the geometry that is left.
vtkPolyData* DrawnSurfaces::clip(vtkPolyData* input, vtkPlaneCollection* planes, const PropPath& path,
                                 const glm::dmat4& modelToWorld)
{
  ClippedMesh& entry = this->clipped[{path, input}];
  entry.used = true;
  std::vector<glm::dvec4> planesMC;
  for (int i = 0; i < planes->GetNumberOfItems(); ++i)
  {
    const glm::dvec3 normalWC = glm::make_vec3(planes->GetItem(i)->GetNormal());
    const glm::dvec3 originWC = glm::make_vec3(planes->GetItem(i)->GetOrigin());
    planesMC.push_back(glm::dvec4(normalWC, -glm::dot(normalWC, originWC)) * modelToWorld);
  }
  // Planes by what they are: a mapper may be given others that are older than its data.
  const vtkMTimeType time = input->GetMTime();
  if (entry.output != nullptr && entry.input == input && entry.time == time && entry.planesMC == planesMC)
  {
    return entry.output;
  }
  vtkSmartPointer<vtkPolyData> current = fan(input);
  for (const glm::dvec4& planeMC : planesMC)
  {
    const double length = glm::length(glm::dvec3(planeMC));
    const glm::dvec3 normalMC = glm::dvec3(planeMC) / length;
    const glm::dvec3 originMC = normalMC * (-planeMC.w / length);
    vtkNew<vtkPlane> plane;
    plane->SetNormal(normalMC.x, normalMC.y, normalMC.z);
    plane->SetOrigin(originMC.x, originMC.y, originMC.z);
    vtkNew<vtkClipPolyData> clipper;
    clipper->SetInputData(current);
    clipper->SetClipFunction(plane);
    clipper->Update();
    current = fan(clipper->GetOutput()); // a clipped triangle can become a quadrilateral
  }
  entry.output = current;
  entry.input = input;
  entry.planesMC = std::move(planesMC);
  entry.time = time;
  return entry.output;
}

void DrawnSurfaces::dropUnused()
{
  sweepUnused(this->surfaces);
  sweepUnused(this->clipped);
}

} // namespace shadow
