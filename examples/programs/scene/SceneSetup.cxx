#include "SceneSetup.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkConeSource.h>
#include <vtkCubeSource.h>
#include <vtkCylinderSource.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkPlaneSource.h>
#include <vtkPlatonicSolidSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace shadow::examples
{
namespace
{

constexpr std::array<Vector3, 6> COLOURS = {{
    {0.87, 0.72, 0.53}, // sand
    {0.45, 0.62, 0.80}, // blue
    {0.80, 0.45, 0.38}, // brick
    {0.55, 0.70, 0.45}, // moss
    {0.73, 0.58, 0.78}, // lilac
    {0.90, 0.80, 0.40}, // straw
}};

constexpr Vector3 FLOOR_COLOUR = {0.82, 0.81, 0.79};

// Of the scene's height: far below what is seen, far above the rounding of coordinates.
constexpr double FLOOR_GAP = 1e-3;

// Of the models' diagonal: the chosen view does not reach the rim, nor does the shadow of a low light.
constexpr double FLOOR_HALF_SIZE = 10.0;

// Some light from everywhere, so that a shadow shows what lies in it.
void setMaterial(vtkProperty* property, const Vector3& colour)
{
  property->SetColor(colour[0], colour[1], colour[2]);
  property->SetAmbient(0.32);
  property->SetDiffuse(0.74);
  property->SetSpecular(0.12);
  property->SetSpecularPower(30.0);
}

vtkSmartPointer<vtkActor> addSurface(vtkRenderer* renderer, vtkPolyData* surface, const Vector3& colour)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  setMaterial(actor->GetProperty(), colour);
  renderer->AddActor(actor);
  return actor;
}

vtkSmartPointer<vtkActor> addSource(vtkRenderer* renderer, vtkPolyDataAlgorithm* source,
                                    const Vector3& colour, const Vector3& position)
{
  source->Update();
  auto actor = addSurface(renderer, source->GetOutput(), colour);
  actor->SetPosition(position[0], position[1], position[2]);
  return actor;
}

} // namespace

vtkBoundingBox addModels(vtkRenderer* renderer, const std::vector<Model>& models)
{
  vtkBoundingBox bounds;
  for (std::size_t i = 0; i < models.size(); ++i)
  {
    for (const ModelPart& part : models[i].parts)
    {
      const auto actor =
          addSurface(renderer, part.surface, part.colour.value_or(COLOURS[i % COLOURS.size()]));
      actor->GetProperty()->SetOpacity(part.opacity);
      bounds.AddBounds(actor->GetBounds());
    }
  }
  return bounds;
}

vtkBoundingBox addBuiltInScene(vtkRenderer* renderer)
{
  vtkNew<vtkParametricTorus> torusShape;
  torusShape->SetRingRadius(0.75);
  torusShape->SetCrossSectionRadius(0.27);
  vtkNew<vtkParametricFunctionSource> torus;
  torus->SetParametricFunction(torusShape);
  torus->SetUResolution(96);
  torus->SetVResolution(48);
  torus->SetWResolution(0);
  const auto ring = addSource(renderer, torus, COLOURS[2], {-0.1, 1.02, 0.0});
  ring->RotateY(35.0);

  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.42);
  sphere->SetThetaResolution(64);
  sphere->SetPhiResolution(48);
  addSource(renderer, sphere, COLOURS[1], {1.35, 0.42, 0.75});

  vtkNew<vtkSphereSource> bead;
  bead->SetRadius(0.22);
  bead->SetThetaResolution(48);
  bead->SetPhiResolution(32);
  addSource(renderer, bead, COLOURS[5], {-0.1, 1.02, 0.0});

  vtkNew<vtkConeSource> cone;
  cone->SetDirection(0.0, 1.0, 0.0);
  cone->SetHeight(1.5);
  cone->SetRadius(0.5);
  cone->SetResolution(64);
  addSource(renderer, cone, COLOURS[3], {-1.6, 0.75, -0.55});

  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetRadius(0.3);
  cylinder->SetHeight(1.9);
  cylinder->SetResolution(64);
  addSource(renderer, cylinder, COLOURS[0], {1.35, 0.95, -0.75});

  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(0.7);
  cube->SetYLength(0.7);
  cube->SetZLength(0.7);
  const auto box = addSource(renderer, cube, COLOURS[4], {-0.9, 0.35, 1.05});
  box->RotateY(25.0);

  vtkBoundingBox bounds;
  double visible[6];
  renderer->ComputeVisiblePropBounds(visible);
  bounds.AddBounds(visible);
  return bounds;
}

vtkBoundingBox addFloor(vtkRenderer* renderer, const vtkBoundingBox& models)
{
  double centre[3];
  models.GetCenter(centre);
  const double diagonal = models.GetDiagonalLength();
  const double height = models.GetLength(1);
  const double y = models.GetMinPoint()[1] - FLOOR_GAP * (height > 0.0 ? height : diagonal);
  const double half = FLOOR_HALF_SIZE * diagonal;

  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(centre[0] - half, y, centre[2] + half);
  plane->SetPoint1(centre[0] + half, y, centre[2] + half);
  plane->SetPoint2(centre[0] - half, y, centre[2] - half);
  plane->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  plane->Update();
  const auto actor = addSurface(renderer, plane->GetOutput(), FLOOR_COLOUR);
  actor->GetProperty()->SetSpecular(0.0);
  return vtkBoundingBox(actor->GetBounds());
}

std::vector<Vector3> samplePoints(vtkRenderer* renderer)
{
  constexpr vtkIdType enough = 4000;
  std::vector<vtkActor*> actors;
  vtkIdType count = 0;
  vtkCollectionSimpleIterator position;
  vtkActorCollection* collection = renderer->GetActors(); // collected anew at each call
  collection->InitTraversal(position);
  while (vtkActor* actor = collection->GetNextActor(position))
  {
    actors.push_back(actor);
    count += actor->GetMapper()->GetInput()->GetNumberOfPoints();
  }
  const vtkIdType step = std::max<vtkIdType>(1, count / enough);
  std::vector<Vector3> points;
  for (vtkActor* actor : actors)
  {
    vtkDataSet* data = actor->GetMapper()->GetInput();
    for (vtkIdType id = 0; id < data->GetNumberOfPoints(); id += step)
    {
      double point[4] = {0.0, 0.0, 0.0, 1.0};
      data->GetPoint(id, point);
      actor->GetMatrix()->MultiplyPoint(point, point);
      points.push_back({point[0], point[1], point[2]});
    }
  }
  return points;
}

void setBackground(vtkRenderer* renderer)
{
  renderer->SetBackground(0.55, 0.58, 0.62);
  renderer->SetBackground2(0.80, 0.84, 0.88);
  renderer->GradientBackgroundOn();
}

} // namespace shadow::examples
