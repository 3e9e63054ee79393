// Outlines of VTK's own sources, held against the truth.
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <vtkAssembly.h>
#include <vtkCamera.h>
#include <vtkConeSource.h>
#include <vtkCubeSource.h>
#include <vtkCylinderSource.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>

#include "OutlineScene.h"

namespace shadow::truth
{

namespace
{

struct SceneCase
{
  const char* name;
  std::function<void(OutlineScene&)> build;
};

// For GoogleTest, which would print its bytes.
void PrintTo(const SceneCase& sceneCase, std::ostream* os)
{
  *os << sceneCase.name;
}

void addCube(OutlineScene& scene)
{
  vtkNew<vtkCubeSource> cube;
  vtkActor* actor = scene.addSource(cube);
  actor->RotateY(20.0);
  actor->RotateX(10.0);
}

void addRing(OutlineScene& scene)
{
  vtkNew<vtkParametricTorus> shape;
  shape->SetRingRadius(0.6);
  shape->SetCrossSectionRadius(0.2);
  vtkNew<vtkParametricFunctionSource> torus;
  torus->SetParametricFunction(shape);
  vtkActor* ring = scene.addSource(torus);
  ring->SetPosition(0.2, 0.4, 0.0);
  ring->RotateX(60.0);
}

void addSolids(OutlineScene& scene)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(32);
  scene.addSource(sphere)->SetPosition(-1.3, 0.0, 0.1);
  addRing(scene);
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetResolution(24);
  cylinder->SetRadius(0.25);
  vtkActor* post = scene.addSource(cylinder);
  post->SetPosition(0.8, 0.1, -0.6);
  post->SetScale(1.0, 1.5, 1.0);
  scene.lookFrom(0.3, 0.6, 1.0, 1.4);
  scene.addFloor(1.2);
}

void addSheets(OutlineScene& scene)
{
  for (const double z : {0.0, 0.3, 0.6})
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetResolution(7, 5);
    vtkActor* actor = scene.addSource(plane);
    actor->SetPosition(0.25 * z, 0.4 * z, z);
    actor->RotateZ(40.0 * z);
  }
}

void addAssembly(OutlineScene& scene)
{
  vtkNew<vtkAssembly> outer;
  outer->RotateZ(25.0);
  outer->SetScale(1.0, 0.5, 2.0);
  vtkNew<vtkAssembly> inner;
  inner->SetPosition(0.4, 0.1, 0.2);
  outer->AddPart(inner);
  for (vtkAssembly* parent : {outer.Get(), inner.Get()})
  {
    vtkNew<vtkConeSource> cone;
    cone->SetResolution(16);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(cone->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    parent->AddPart(actor);
  }
  scene.renderer->AddActor(outer);
}

void lookParallel(OutlineScene& scene, double share)
{
  vtkCamera* camera = scene.renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(share * camera->GetDistance());
}

/// From within the ring of spheres and boxes, the near plane through some.
void standInside(OutlineScene& scene)
{
  addSolids(scene);
  vtkCamera* camera = scene.renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.1, 1.1);
  camera->SetFocalPoint(-0.2, -0.1, -1.0);
  camera->SetViewAngle(75.0);
}

std::vector<SceneCase> makeSceneCases()
{
  return {
      {"Cube",
       [](OutlineScene& scene)
       {
         addCube(scene);
         scene.lookFrom(0.4, 0.5, 1.0);
       }},
      {"CubeParallel",
       [](OutlineScene& scene)
       {
         addCube(scene);
         scene.lookFrom(0.4, 0.5, 1.0);
         lookParallel(scene, 0.3);
       }},
      {"Torus",
       [](OutlineScene& scene)
       {
         addRing(scene);
         scene.lookFrom(0.1, 0.3, 1.0);
       }},
      {"TorusWhoseSeamMissesItselfByRounding",
       [](OutlineScene& scene)
       {
         vtkNew<vtkParametricTorus> shape;
         vtkNew<vtkParametricFunctionSource> torus;
         torus->SetParametricFunction(shape);
         scene.addSource(torus);
         scene.lookFrom(0.8, -0.5, 0.6);
       }},
      {"FineSphereSmall",
       [](OutlineScene& scene)
       {
         vtkNew<vtkSphereSource> sphere;
         sphere->SetThetaResolution(200);
         sphere->SetPhiResolution(200);
         scene.addSource(sphere);
         scene.lookFrom(0.4, 0.5, 1.0, 12.0);
       }},
      {"Solids", addSolids},
      {"SolidsParallel",
       [](OutlineScene& scene)
       {
         addSolids(scene);
         lookParallel(scene, 0.25);
       }},
      {"SolidsFromInside", standInside},
      {"OpenSheets",
       [](OutlineScene& scene)
       {
         addSheets(scene);
         scene.lookFrom(0.3, 0.2, 1.0);
       }},
      {"OpenSheetsFromBehind",
       [](OutlineScene& scene)
       {
         addSheets(scene);
         scene.lookFrom(0.3, 0.2, -1.0);
       }},
      {"Assembly",
       [](OutlineScene& scene)
       {
         addAssembly(scene);
         scene.lookFrom(0.3, 0.4, 1.0);
       }},
      {"FarFromTheOrigin",
       [](OutlineScene& scene)
       {
         addCube(scene);
         addCube(scene);
         vtkActorCollection* actors = scene.renderer->GetActors();
         actors->InitTraversal();
         actors->GetNextActor()->SetPosition(1e6, -2e6, 5e5);
         actors->GetNextActor()->SetPosition(1e6 + 0.7, -2e6 + 0.6, 5e5 - 0.9);
         scene.lookFrom(0.4, 0.5, 1.0);
       }},
      {"WideTelephoto",
       [](OutlineScene& scene)
       {
         addSolids(scene);
         vtkCamera* camera = scene.renderer->GetActiveCamera();
         camera->Dolly(0.02);
         camera->SetViewAngle(0.6);
       }},
  };
}

} // namespace

class SceneOutline : public testing::TestWithParam<SceneCase>
{
};

TEST_P(SceneOutline, EveryWidth_LinesAreTrue)
{
  OutlineScene scene(640, 480);
  GetParam().build(scene);
  scene.renderer->ResetCameraClippingRange();
  scene.window->Render();
  const OutlineTruth truth = scene.makeOutline();
  expectTrueLines(scene, truth);
  scene.outlines->SetTechniqueToFaces();
  expectTrueLines(scene, truth, "Faces");
}

INSTANTIATE_TEST_SUITE_P(Scenes, SceneOutline, testing::ValuesIn(makeSceneCases()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(SceneOutline, DelegateWithShadows_LeavesTheLinesAsTheyAre)
{
  OutlineScene scene(320, 240);
  addSolids(scene);
  scene.addPointLight(0.5, 4.0, 1.5);
  scene.renderer->ResetCameraClippingRange();
  const std::vector<unsigned char> alone = scene.renderLines(3.0);
  scene.outlines->SetDelegatePass(scene.pass);
  EXPECT_EQ(scene.renderLines(3.0), alone);
  EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_OK);
}

} // namespace shadow::truth
