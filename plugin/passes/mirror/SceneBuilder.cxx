#include "SceneBuilder.h"

#include <algorithm>

#include <glm/gtc/type_ptr.hpp>

#include <vtkActor.h>
#include <vtkAssemblyNode.h>
#include <vtkAssemblyPath.h>
#include <vtkFollower.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyData.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "ActorTraits.h"
#include "MovedVertices.h"
#include "SweepUnused.h"

namespace shadow
{

bool SceneBuilder::update(vtkRenderer* renderer, const Settings& settings, Group& root)
{
  const std::set<vtkProp*> mirroredBefore = std::move(this->mirrored);
  const std::set<vtkMapper*> mappersBefore = std::move(this->mappersOfOthers);
  this->mirrored.clear();
  this->mappersOfOthers.clear();
  this->skipped.clear();
  this->errors.clear();
  this->errorsByPlacement.clear();
  this->placements.clear();
  this->currentPlacement = 0;
  this->triangles = 0;
  this->seenThrough = false;
  this->moreDrawn = false;
  this->widestLine = 0.0;
  this->blendedAsOpaque = false;
  this->unlit = 0;
  this->propNumber = -1;
  this->updated.clear();
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
      this->addProp(prop, settings);
    }
  }
  this->meshes.build();
  this->show(settings, root);
  this->dropUnused();
  return this->mirrored != mirroredBefore || this->mappersOfOthers != mappersBefore;
}

void SceneBuilder::addProp(vtkProp* prop, const Settings& settings)
{
  if (auto* actor = vtkActor::SafeDownCast(prop))
  {
    // The only way to it, without what VTK makes for each way.
    this->addPath({prop}, true, actor->GetMatrix(), settings);
    return;
  }
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
    this->addPath(path, visible, assemblyPath->GetLastNode()->GetMatrix(), settings);
  }
}

void SceneBuilder::addPath(const PropPath& path, bool visible, vtkMatrix4x4* matrix, const Settings& settings)
{
  vtkProp* end = path.back();
  this->blendedAsOpaque = this->blendedAsOpaque || (visible && isBlendedAsOpaque(end));
  if (!visible || end->IsA("vtkSkybox") != 0)
  {
    return; // a skybox is a backdrop: its cube is nowhere in the scene
  }
  vtkActor* actor = vtkActor::SafeDownCast(end);
  if (actor != nullptr && actor->GetMapper() != nullptr)
  {
    Placement placement;
    placement.actor = actor;
    this->addActor(placement, path, matrix, settings);
    this->placements.push_back(std::move(placement));
    this->currentPlacement += 1;
    return;
  }
  this->moreDrawn = this->moreDrawn || mayBeOpaque(end);
  if (end->IsA("vtkImageSlice") != 0 || end->IsA("vtkLODProp3D") != 0)
  {
    this->refuse(this->describe(end), "it is no vtkActor", settings);
  }
}

void SceneBuilder::addActor(Placement& placement, const PropPath& path, vtkMatrix4x4* matrix,
                            const Settings& settings)
{
  vtkActor* actor = placement.actor;
  vtkMapper* mapper = actor->GetMapper();
  if (mapper->GetNumberOfInputConnections(0) == 0 && mapper->GetInputDataObject(0, 0) == nullptr)
  {
    return;
  }
  if (this->updated.insert(mapper).second)
  {
    mapper->Update();
  }
  const bool isForced = actor->GetForceOpaque() && isBlendedAsOpaque(actor);
  if (!actor->HasOpaqueGeometry() || isForced)
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
  if (!DrawnSurfaces::areKnown(mapper))
  {
    this->refuse(this->describe(actor), std::string("its mapper is a ") + mapper->GetClassName(), settings);
    return;
  }

  if (movesVertices(actor))
  {
    this->skip(actor, "its shaders may move its vertices");
    return;
  }

  PlacedActor& placed = this->transforms[path];
  placed.used = true;
  const std::shared_ptr<Transform>& transform = placed.transform;
  transform->name = this->describe(actor);
  transform->faceCulling = faceCullingOf(actor);
  transform->drawn = settings.drawn.count(path.front()) != 0;
  transform->casting = std::all_of(path.begin(), path.end(), settings.isCasting);
  // VTK stores row-major, GLM column-major.
  transform->matrix = glm::transpose(glm::make_mat4(matrix->GetData()));
  if (!isInvertible(transform->matrix))
  {
    const std::string reason = "its transform flattens it or is not finite";
    this->refuse(transform->name, reason, settings);
    return;
  }
  const std::vector<vtkPolyData*> drawn = this->surfaces.collect(actor, path, transform->matrix);
  placed.surfaces = drawn.size();
  if (hasTubesOrSpheres(actor, drawn))
  {
    this->skip(actor, "its lines are drawn as tubes, or its points as spheres");
  }
  const MeshStore::Options options{settings.weldTolerance, settings.weldsRounding, settings.copiesCountOnce};
  for (std::size_t place = 0; place < drawn.size(); ++place)
  {
    this->meshes.request(drawn[place], place < placed.shown.size() ? placed.shown[place] : nullptr, options);
  }
  placement.placed = &placed;
  placement.hasLines = hasLinesOrPoints(actor, drawn);
  placement.drawn.assign(drawn.begin(), drawn.end());
}

/// What has been placed, in the same order, with meshes.
void SceneBuilder::show(const Settings& settings, Group& root)
{
  this->currentPlacement = 0;
  for (const Placement& placement : this->placements)
  {
    vtkActor* actor = placement.actor;
    if (placement.placed != nullptr)
    {
      this->showActor(placement, settings, root);
    }
    if (this->mirrored.count(actor) == 0)
    {
      this->mappersOfOthers.insert(actor->GetMapper());
      this->moreDrawn = this->moreDrawn || actor->HasOpaqueGeometry() != 0;
      this->noteLines(actor, drawsLines(actor));
    }
    this->currentPlacement += 1;
  }
  this->placements.clear();
  for (auto& [place, error] : this->errorsByPlacement)
  {
    this->errors.push_back(std::move(error));
  }
}

void SceneBuilder::showActor(const Placement& placement, const Settings& settings, Group& root)
{
  vtkActor* actor = placement.actor;
  PlacedActor& placed = *placement.placed;
  const std::shared_ptr<Transform>& transform = placed.transform;
  placed.shown.clear();
  transform->clearChildren();
  for (vtkPolyData* polyData : placement.drawn)
  {
    const MeshStore::Mesh& mesh = this->meshes.get(polyData);
    placed.shown.push_back(mesh.geode);
    if (mesh.geode != nullptr)
    {
      transform->addChild(mesh.geode);
      this->triangles += mesh.geode->getGeometry().getReport().inputTriangles;
    }
    if (!mesh.error.empty())
    {
      this->refuse(transform->name, mesh.error, settings);
    }
  }
  if (!transform->getChildren().empty())
  {
    root.addChild(transform);
    if (this->mirrored.insert(actor).second && !actor->GetProperty()->GetLighting())
    {
      this->firstUnlit = this->unlit == 0 ? transform->name : this->firstUnlit;
      this->unlit += 1;
    }
    this->seenThrough = this->seenThrough || letsThrough(actor);
    const auto unusable = std::count(placed.shown.begin(), placed.shown.end(), nullptr);
    this->moreDrawn = this->moreDrawn || unusable > 0 || placement.hasLines;
    this->noteLines(actor, placement.hasLines || actor->GetProperty()->GetEdgeVisibility() != 0);
  }
}

bool SceneBuilder::isMirrored(vtkProp* prop) const
{
  auto* actor = vtkActor::SafeDownCast(prop);
  return this->mirrored.count(prop) != 0 && this->mappersOfOthers.count(actor->GetMapper()) == 0;
}

vtkProp* SceneBuilder::findActor(const Node* transform) const
{
  vtkProp* actor = nullptr;
  for (const auto& [path, placed] : this->transforms)
  {
    if (placed.transform.get() == transform && placed.surfaces == 1)
    {
      actor = path.back();
    }
  }
  const auto places = std::count_if(this->transforms.begin(), this->transforms.end(),
                                    [&](const auto& entry) { return entry.first.back() == actor; });
  return places == 1 ? actor : nullptr;
}

void SceneBuilder::noteLines(vtkActor* actor, bool hasLines)
{
  if (hasLines)
  {
    vtkProperty* property = actor->GetProperty();
    this->widestLine = std::max({this->widestLine, 1.0, double{property->GetLineWidth()},
                                 double{property->GetPointSize()}});
  }
}

void SceneBuilder::refuse(const std::string& name, const std::string& reason, const Settings& settings)
{
  this->skipped.insert({name, reason});
  this->errorsByPlacement.emplace(this->currentPlacement,
                                  name + " has no " + settings.product + ": " + reason);
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
  this->meshes.dropUnused();
  sweepUnused(this->transforms);
  this->surfaces.dropUnused();
}

} // namespace shadow
