#include "SceneBuilder.h"

#include <algorithm>

#include <glm/gtc/type_ptr.hpp>

#include <vtkActor.h>
#include <vtkAssemblyNode.h>
#include <vtkAssemblyPath.h>
#include <vtkClipPolyData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataSetMapper.h>
#include <vtkFollower.h>
#include <vtkMatrix4x4.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "MeshImport.h"
#include "vtkShadowCompat.h"

namespace shadow
{

namespace
{

FaceCulling faceCullingOf(vtkActor* actor)
{
  const bool back = actor->GetProperty()->GetBackfaceCulling() != 0;
  const bool front = actor->GetProperty()->GetFrontfaceCulling() != 0;
  return back && front ? FaceCulling::Both
                       : (back ? FaceCulling::Back : (front ? FaceCulling::Front : FaceCulling::None));
}

bool isBlockVisible(vtkMapper* mapper, vtkDataObject* block)
{
  auto* composite = vtkShadowCompositeMapper::SafeDownCast(mapper);
  vtkCompositeDataDisplayAttributes* attributes =
      composite != nullptr ? composite->GetCompositeDataDisplayAttributes() : nullptr;
  return attributes == nullptr || !attributes->HasBlockVisibility(block) || attributes->GetBlockVisibility(block);
}

// The mapper that draws: a vtkDataSetMapper has one inside.
vtkMapper* drawingMapper(vtkMapper* mapper)
{
  auto* dataSetMapper = vtkDataSetMapper::SafeDownCast(mapper);
  return dataSetMapper != nullptr && dataSetMapper->GetPolyDataMapper() != nullptr
             ? dataSetMapper->GetPolyDataMapper()
             : mapper;
}

// Mappers that draw something else than the polygons they are given.
bool drawsItsPolygons(vtkMapper* mapper)
{
  if (mapper->IsA("vtkGlyph3DMapper") || mapper->IsA("vtkPointGaussianMapper") ||
      mapper->IsA("vtkOpenGLSphereMapper") || mapper->IsA("vtkOpenGLStickMapper"))
  {
    return false;
  }
  return mapper->IsA("vtkPolyDataMapper") || vtkShadowCompositeMapper::SafeDownCast(mapper) != nullptr;
}

} // namespace

bool SceneBuilder::update(vtkRenderer* renderer, const Settings& settings, Group& root)
{
  const std::set<vtkProp*> mirroredBefore = std::move(this->mirrored);
  this->mirrored.clear();
  this->skipped.clear();
  this->errors.clear();
  this->triangles = 0;
  this->propNumber = -1;
  root.clearChildren();
  // All props, not those that VTK's cullers left: a caster outside the view may shadow what is inside.
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    this->propNumber += 1;
    if (prop->GetVisibility() != 0)
    {
      this->addProp(prop, settings, root);
    }
  }
  this->dropUnused();
  return this->mirrored != mirroredBefore;
}

void SceneBuilder::addProp(vtkProp* prop, const Settings& settings, Group& root)
{
  prop->InitPathTraversal();
  while (vtkAssemblyPath* assemblyPath = prop->GetNextPath())
  {
    PropPath path;
    bool visible = true;
    vtkCollectionSimpleIterator iterator;
    assemblyPath->InitTraversal(iterator);
    while (vtkAssemblyNode* node = assemblyPath->GetNextNode(iterator))
    {
      path.push_back(node->GetViewProp());
      visible = visible && node->GetViewProp()->GetVisibility() != 0;
    }
    vtkActor* actor = vtkActor::SafeDownCast(path.back());
    if (visible && actor != nullptr && actor->GetMapper() != nullptr)
    {
      this->addActor(actor, path, assemblyPath, settings, root);
    }
  }
}

void SceneBuilder::addActor(vtkActor* actor, const PropPath& path, vtkAssemblyPath* assemblyPath,
                            const Settings& settings, Group& root)
{
  vtkMapper* mapper = actor->GetMapper();
  if (mapper->GetNumberOfInputConnections(0) == 0 && mapper->GetInputDataObject(0, 0) == nullptr)
  {
    return;
  }
  mapper->Update();
  if (!actor->HasOpaqueGeometry())
  {
    this->skip(actor, "it is translucent");
    return;
  }
  if (actor->GetProperty()->GetRepresentation() != VTK_SURFACE)
  {
    this->skip(actor, "it is not drawn as a surface");
    return;
  }
  if (vtkFollower::SafeDownCast(actor) != nullptr)
  {
    this->skip(actor, "it turns with the camera");
    return;
  }
  if (!drawsItsPolygons(drawingMapper(mapper)))
  {
    this->skip(actor, std::string("its mapper is a ") + drawingMapper(mapper)->GetClassName());
    return;
  }

  auto& [transform, used] = this->transforms[path];
  if (transform == nullptr)
  {
    transform = std::make_shared<Transform>();
  }
  used = true;
  transform->name = this->describe(actor);
  transform->faceCulling = faceCullingOf(actor);
  transform->casting = std::all_of(path.begin(), path.end(), settings.isCasting);
  // VTK stores row-major, GLM column-major.
  transform->matrix = glm::transpose(glm::make_mat4(assemblyPath->GetLastNode()->GetMatrix()->GetData()));
  transform->clearChildren();
  for (vtkPolyData* polyData : this->collectData(actor, path, transform->matrix))
  {
    if (const std::shared_ptr<SEDGeode> geode = this->getGeode(polyData, settings, transform->name))
    {
      transform->addChild(geode);
      this->triangles += geode->getGeometry().getReport().inputTriangles;
    }
  }
  if (!transform->getChildren().empty())
  {
    root.addChild(transform);
    this->mirrored.insert(actor);
  }
}

std::vector<vtkPolyData*> SceneBuilder::collectData(vtkActor* actor, const PropPath& path,
                                                    const glm::dmat4& modelToWorld)
{
  vtkMapper* mapper = drawingMapper(actor->GetMapper());
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  std::vector<vtkPolyData*> data;
  if (auto* polyData = vtkPolyData::SafeDownCast(input))
  {
    data.push_back(polyData);
  }
  else if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      auto* block = vtkPolyData::SafeDownCast(iterator->GetCurrentDataObject());
      if (block != nullptr && isBlockVisible(mapper, block))
      {
        data.push_back(block);
      }
    }
  }
  vtkPlaneCollection* planes = actor->GetMapper()->GetClippingPlanes();
  if (planes != nullptr && planes->GetNumberOfItems() > 0)
  {
    std::transform(data.begin(), data.end(), data.begin(), [&](vtkPolyData* polyData) {
      return this->clip(polyData, planes, path, modelToWorld);
    });
  }
  return data;
}

// VTK clips in the shader, by planes in world space; a shadow needs the geometry that is left.
vtkPolyData* SceneBuilder::clip(vtkPolyData* input, vtkPlaneCollection* planes, const PropPath& path,
                                const glm::dmat4& modelToWorld)
{
  ClippedMesh& entry = this->clipped[{path, input}];
  entry.used = true;
  vtkMTimeType time = std::max(input->GetMTime(), planes->GetMTime());
  for (int i = 0; i < planes->GetNumberOfItems(); ++i)
  {
    time = std::max(time, planes->GetItem(i)->GetMTime());
  }
  if (entry.output != nullptr && entry.input == input && entry.time == time && entry.modelToWorld == modelToWorld)
  {
    return entry.output;
  }
  vtkSmartPointer<vtkPolyData> current = vtkSmartPointer<vtkPolyData>::New();
  current->CopyStructure(input);
  for (int i = 0; i < planes->GetNumberOfItems(); ++i)
  {
    double* normal = planes->GetItem(i)->GetNormal();
    double* origin = planes->GetItem(i)->GetOrigin();
    const glm::dvec3 normalWC(normal[0], normal[1], normal[2]);
    const glm::dvec3 originWC(origin[0], origin[1], origin[2]);
    const glm::dvec4 planeMC = glm::dvec4(normalWC, -glm::dot(normalWC, originWC)) * modelToWorld;
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
    current = clipper->GetOutput();
  }
  entry.output = current;
  entry.input = input;
  entry.modelToWorld = modelToWorld;
  entry.time = time;
  return entry.output;
}

std::shared_ptr<SEDGeode> SceneBuilder::getGeode(vtkPolyData* polyData, const Settings& settings,
                                                 const std::string& name)
{
  Mesh& mesh = this->meshes[polyData];
  mesh.used = true;
  // GetMTime() covers points and cells as well as a call of Modified() on the data set after a change in place.
  const vtkMTimeType time = polyData->GetMTime();
  if (mesh.polyData != polyData || mesh.time != time || mesh.weldTolerance != settings.weldTolerance)
  {
    mesh.polyData = polyData;
    mesh.time = time;
    mesh.weldTolerance = settings.weldTolerance;
    mesh.geode.reset();
    mesh.error.clear();
    TriangleSoup soup = importTriangles(polyData);
    if (!soup.triangles.empty())
    {
      std::optional<SEDGeometry> geometry =
          buildSEDGeometry(std::move(soup), SEDGeometryOptions{settings.weldTolerance}, mesh.error);
      if (geometry)
      {
        mesh.geode = std::make_shared<SEDGeode>(std::make_shared<const SEDGeometry>(std::move(*geometry)));
        mesh.geode->name = name;
      }
    }
  }
  if (!mesh.error.empty())
  {
    this->skipped.insert({name, mesh.error});
    this->errors.push_back(name + " has no shadow: " + mesh.error);
  }
  return mesh.geode;
}

std::string SceneBuilder::describe(vtkProp* prop) const
{
  return std::string(prop->GetClassName()) + " in prop " + std::to_string(this->propNumber);
}

void SceneBuilder::skip(vtkProp* prop, const std::string& reason)
{
  this->skipped.insert({this->describe(prop), reason});
}

void SceneBuilder::dropUnused()
{
  const auto sweep = [](auto& map, auto&& isUsed) {
    for (auto entry = map.begin(); entry != map.end();)
    {
      bool& used = isUsed(entry->second);
      entry = used ? std::next(entry) : map.erase(entry);
    }
    for (auto& entry : map)
    {
      isUsed(entry.second) = false;
    }
  };
  sweep(this->meshes, [](Mesh& mesh) -> bool& { return mesh.used; });
  sweep(this->clipped, [](ClippedMesh& mesh) -> bool& { return mesh.used; });
  sweep(this->transforms, [](auto& entry) -> bool& { return entry.second; });
  for (auto& entry : this->meshes)
  {
    if (entry.second.geode != nullptr)
    {
      entry.second.geode->dropUnusedPaths();
    }
  }
}

std::size_t SceneBuilder::getMemorySize() const
{
  std::size_t bytes = 0;
  for (const auto& entry : this->meshes)
  {
    if (entry.second.geode != nullptr)
    {
      bytes += entry.second.geode->getGeometry().getMemorySize() + entry.second.geode->getMemorySize();
    }
  }
  return bytes;
}

} // namespace shadow
