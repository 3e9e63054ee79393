#include "SceneBuilder.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
#include "MeshImport.h"
#include "MovedVertices.h"
#include "SweepUnused.h"

namespace shadow
{

namespace
{

/// Two roundings of single precision, for a coordinate as large as the mesh: what sin(2 pi) misses 0 by,
/// times its radius, is less.
double chooseWeldTolerance(vtkPolyData* polyData, const SceneBuilder::Settings& settings)
{
  constexpr double rounding = 2.0 * std::numeric_limits<float>::epsilon();
  const double size = settings.weldsRounding ? polyData->GetLength() : 0.0;
  return std::max(settings.weldTolerance, std::isfinite(size) ? rounding * size : 0.0);
}

} // namespace

bool SceneBuilder::update(vtkRenderer* renderer, const Settings& settings, Group& root)
{
  const std::set<vtkProp*> mirroredBefore = std::move(this->mirrored);
  const std::set<vtkMapper*> mappersBefore = std::move(this->mappersOfOthers);
  this->mirrored.clear();
  this->mappersOfOthers.clear();
  this->skipped.clear();
  this->errors.clear();
  this->triangles = 0;
  this->seenThrough = false;
  this->moreDrawn = false;
  this->widestLine = 0.0;
  this->blendedAsOpaque = false;
  this->unlit = 0;
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
  return this->mirrored != mirroredBefore || this->mappersOfOthers != mappersBefore;
}

void SceneBuilder::addProp(vtkProp* prop, const Settings& settings, Group& root)
{
  if (auto* actor = vtkActor::SafeDownCast(prop))
  {
    // The only way to it, without what VTK makes for each way.
    this->addPath({prop}, true, actor->GetMatrix(), settings, root);
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
    this->addPath(path, visible, assemblyPath->GetLastNode()->GetMatrix(), settings, root);
  }
}

void SceneBuilder::addPath(const PropPath& path, bool visible, vtkMatrix4x4* matrix, const Settings& settings,
                           Group& root)
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
    this->addActor(actor, path, matrix, settings, root);
    if (this->mirrored.count(actor) == 0)
    {
      this->mappersOfOthers.insert(actor->GetMapper());
      this->moreDrawn = this->moreDrawn || actor->HasOpaqueGeometry() != 0;
      this->noteLines(actor, drawsLines(actor));
    }
    return;
  }
  this->moreDrawn = this->moreDrawn || mayBeOpaque(end);
  if (end->IsA("vtkImageSlice") != 0 || end->IsA("vtkLODProp3D") != 0)
  {
    this->refuse(this->describe(end), "it is no vtkActor", settings);
  }
}

void SceneBuilder::addActor(vtkActor* actor, const PropPath& path, vtkMatrix4x4* matrix,
                            const Settings& settings, Group& root)
{
  vtkMapper* mapper = actor->GetMapper();
  if (mapper->GetNumberOfInputConnections(0) == 0 && mapper->GetInputDataObject(0, 0) == nullptr)
  {
    return;
  }
  mapper->Update();
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
  const std::vector<std::shared_ptr<SEDGeode>> shownBefore = std::move(placed.shown);
  placed.shown.clear();
  transform->clearChildren();
  const std::vector<vtkPolyData*> drawn = this->surfaces.collect(actor, path, transform->matrix);
  placed.surfaces = drawn.size();
  if (hasTubesOrSpheres(actor, drawn))
  {
    this->skip(actor, "its lines are drawn as tubes, or its points as spheres");
  }
  for (vtkPolyData* polyData : drawn)
  {
    const std::size_t place = placed.shown.size();
    const std::shared_ptr<SEDGeode> geode = this->getGeode(
        polyData, place < shownBefore.size() ? shownBefore[place] : nullptr, settings, transform->name);
    placed.shown.push_back(geode);
    if (geode != nullptr)
    {
      transform->addChild(geode);
      this->triangles += geode->getGeometry().getReport().inputTriangles;
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
    const bool hasLines = hasLinesOrPoints(actor, drawn);
    this->moreDrawn = this->moreDrawn || unusable > 0 || hasLines;
    this->noteLines(actor, hasLines || actor->GetProperty()->GetEdgeVisibility() != 0);
  }
}

std::shared_ptr<SEDGeode> SceneBuilder::getGeode(vtkPolyData* polyData,
                                                 const std::shared_ptr<SEDGeode>& shownBefore,
                                                 const Settings& settings, const std::string& name)
{
  Mesh& mesh = this->meshes[polyData];
  mesh.used = true;
  // GetMTime() covers points and cells as well as a call of Modified() on the data set after a change in
  // place.
  const vtkMTimeType time = polyData->GetMTime();
  const double weldTolerance = chooseWeldTolerance(polyData, settings);
  if (mesh.polyData != polyData || mesh.time != time || mesh.weldTolerance != weldTolerance)
  {
    mesh.polyData = polyData;
    mesh.time = time;
    mesh.weldTolerance = weldTolerance;
    const std::shared_ptr<SEDGeode> previous = mesh.geode != nullptr ? std::move(mesh.geode) : shownBefore;
    mesh.geode.reset();
    mesh.error.clear();
    TriangleSoup soup = importTriangles(polyData);
    if (!soup.triangles.empty())
    {
      const SEDGeometryOptions options{weldTolerance, settings.copiesCountOnce,
                                       previous != nullptr ? &previous->getGeometry() : nullptr};
      std::optional<SEDGeometry> geometry = buildSEDGeometry(std::move(soup), options, mesh.error);
      if (geometry)
      {
        mesh.geode = std::make_shared<SEDGeode>(std::make_shared<const SEDGeometry>(std::move(*geometry)));
      }
    }
  }
  if (!mesh.error.empty())
  {
    this->refuse(name, mesh.error, settings);
  }
  return mesh.geode;
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
  this->errors.push_back(name + " has no " + settings.product + ": " + reason);
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
  sweepUnused(this->meshes);
  sweepUnused(this->transforms);
  this->surfaces.dropUnused();
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
