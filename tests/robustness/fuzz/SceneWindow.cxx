#include "SceneWindow.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <tuple>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCullerCollection.h>
#include <vtkMatrix4x4.h>
#include <vtkPoints.h>

#include "ActorPoints.h"
#include "SceneFromRenderer.h"

namespace shadow::fuzz
{

namespace
{

/// Levels of 255 by which a picture added up light by light may be off, through rounding to 8 bits twice.
constexpr int pictureTolerance = 3;

vtkSmartPointer<vtkPolyData> toPolyData(const FuzzMesh& mesh, const FuzzScene& scene)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(scene.doublePoints ? VTK_DOUBLE : VTK_FLOAT);
  vtkNew<vtkCellArray> polygons;
  std::map<std::tuple<double, double, double>, vtkIdType> known;
  for (const FuzzTriangle& triangle : mesh.triangles)
  {
    polygons->InsertNextCell(3);
    for (const glm::dvec3& corner : triangle)
    {
      const glm::dvec3 point = toActorPoint(corner, mesh.worldFromMC, scene.doublePoints);
      const auto [at, isNew] = known.try_emplace({point.x, point.y, point.z}, points->GetNumberOfPoints());
      if (isNew || !scene.sharedPoints)
      {
        at->second = points->InsertNextPoint(&point[0]);
      }
      polygons->InsertCellPoint(at->second);
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(polygons);
  return data;
}

void placeActor(vtkActor* actor, const glm::dmat4& worldFromMC)
{
  if (worldFromMC == glm::dmat4(1.0))
  {
    return;
  }
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      matrix->SetElement(row, column, worldFromMC[column][row]);
    }
  }
  actor->SetUserMatrix(matrix);
}

void placeCamera(vtkCamera* camera, const FuzzCamera& from)
{
  camera->SetPosition(&from.position[0]);
  camera->SetFocalPoint(&from.focalPoint[0]);
  camera->SetViewUp(&from.viewUp[0]);
  camera->SetViewAngle(from.viewAngle);
  camera->SetParallelProjection(from.parallelScale.has_value());
  camera->SetParallelScale(from.parallelScale.value_or(1.0));
  camera->SetClippingRange(from.clippingRange.x, from.clippingRange.y);
}

/// Whether all triangles are lines, as far as single precision tells.
bool hasNoArea(const FuzzMesh& mesh)
{
  constexpr double thinnest = 1e-6;
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(),
                     [](const FuzzTriangle& triangle)
                     {
                       const glm::dvec3 u = triangle[1] - triangle[0];
                       const glm::dvec3 v = triangle[2] - triangle[0];
                       const double longest = std::max(glm::dot(u, u), glm::dot(v, v));
                       return glm::length(glm::cross(u, v)) <= thinnest * longest;
                     });
}

} // namespace

void SceneWindow::show(const FuzzScene& scene)
{
  vtkRenderer* renderer = this->window.renderer;
  renderer->GetCullers()->RemoveAllItems(); // rays know no far plane, beyond which VTK would leave out props
  renderer->RemoveAllViewProps();
  renderer->RemoveAllLights();
  this->window.window->SetSize(scene.size.x, scene.size.y);
  for (const FuzzMesh& mesh : scene.meshes)
  {
    if (!mesh.triangles.empty())
    {
      placeActor(this->window.addPolyData(toPolyData(mesh, scene)), mesh.worldFromMC);
    }
  }
  this->hasEmptyMesh = std::any_of(scene.meshes.begin(), scene.meshes.end(), hasNoArea);
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPositional(scene.light.positional);
  light->SetConeAngle(scene.light.coneAngle);
  light->SetPosition(&scene.light.position[0]);
  light->SetFocalPoint(&scene.light.focalPoint[0]);
  renderer->AddLight(light);
  vtkNew<vtkCamera> camera;
  placeCamera(camera, scene.camera);
  renderer->SetActiveCamera(camera);
}

void SceneWindow::use(const FuzzConfig& config)
{
  this->window.pass->SetStencilMethod(config.stencil);
  this->window.pass->SetSilhouetteMethod(config.silhouette);
  this->window.pass->SetCompositing(config.compositing);
  this->window.pass->SetCountBuffer(config.countBuffer);
  this->window.pass->SetSavings(config.alone ? vtkShadowVolumePass::SAVINGS_NONE : vtkShadowVolumePass::SAVINGS_ALL);
}

DrawnMask SceneWindow::draw(const FuzzConfig& config)
{
  this->use(config);
  DrawnMask drawn;
  drawn.config = config;
  drawn.mask = this->window.renderMask();
  const int status = this->window.pass->GetStatus();
  if (status != vtkShadowVolumePass::STATUS_OK &&
      !(status == vtkShadowVolumePass::STATUS_PARTIAL && this->hasEmptyMesh))
  {
    drawn.refusal = this->window.pass->GetStatusMessage();
  }
  else if (config.compositing == vtkShadowVolumePass::COMPOSITING_ADDITIVE)
  {
    drawn.wrongInPicture = this->comparePictures(config);
  }
  return drawn;
}

std::size_t SceneWindow::comparePictures(const FuzzConfig& config)
{
  const std::vector<unsigned char> added = this->window.renderPicture();
  FuzzConfig byMask = config;
  byMask.compositing = vtkShadowVolumePass::COMPOSITING_MASK;
  this->use(byMask);
  const std::vector<unsigned char> masked = this->window.renderPicture();
  std::size_t different = 0;
  for (std::size_t pixel = 0; pixel < added.size(); pixel += 3)
  {
    bool differs = false;
    for (std::size_t i = pixel; i < pixel + 3; ++i)
    {
      differs = differs || std::abs(int{added[i]} - int{masked[i]}) > pictureTolerance;
    }
    different += differs ? 1 : 0;
  }
  return different;
}

truth::Scene SceneWindow::getTruthScene()
{
  return truth::sceneFromRenderer(this->window.renderer);
}

truth::View SceneWindow::getView()
{
  return truth::viewFromRenderer(this->window.renderer);
}

truth::Light SceneWindow::getLight()
{
  return truth::lightsFromRenderer(this->window.renderer).at(0).light;
}

} // namespace shadow::fuzz
