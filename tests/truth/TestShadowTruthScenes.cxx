// Scenes of VTK's own sources, held against the truth.
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <vtkCamera.h>
#include <vtkCylinderSource.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkSphereSource.h>

#include "ExpectTrueMask.h"

namespace shadow::truth
{

namespace
{

/// Three solids on a floor, seen from above at a slant.
class Solids : public ShadowScene
{
public:
  Solids() : ShadowScene(640, 480)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetThetaResolution(48);
    sphere->SetPhiResolution(32);
    this->addSource(sphere)->SetPosition(-1.3, 0.0, 0.1);

    vtkNew<vtkParametricTorus> shape;
    shape->SetRingRadius(0.6);
    shape->SetCrossSectionRadius(0.2);
    vtkNew<vtkParametricFunctionSource> torus;
    torus->SetParametricFunction(shape);
    vtkActor* ring = this->addSource(torus);
    ring->SetPosition(0.2, 0.4, 0.0);
    ring->RotateX(60.0);

    vtkNew<vtkCylinderSource> cylinder;
    cylinder->SetResolution(24);
    cylinder->SetRadius(0.25);
    vtkActor* post = this->addSource(cylinder);
    post->SetPosition(1.5, 0.1, -0.3);
    post->SetScale(1.0, 1.5, 1.0);

    this->lookFrom(0.3, 0.6, 1.0, 1.8);
    this->addFloor(2.5);
    this->renderer->ResetCameraClippingRange();
  }
};

struct LightCase
{
  const char* name;
  std::function<void(Solids&)> addLights;
  int lights = 1;
};

// For GoogleTest, which would print its bytes.
void PrintTo(const LightCase& lightCase, std::ostream* os)
{
  *os << lightCase.name;
}

vtkLight* addSpotLight(ShadowScene& scene, const glm::dvec3& position, double cone)
{
  vtkLight* light = scene.addPointLight(position.x, position.y, position.z);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetConeAngle(cone);
  return light;
}

std::vector<LightCase> makeLightCases()
{
  return {
      {"PointAbove", [](Solids& scene) { scene.addPointLight(0.5, 4.0, 1.5); }},
      {"PointLow", [](Solids& scene) { scene.addPointLight(-4.0, 0.9, 1.0); }},
      {"Directional", [](Solids& scene) { scene.addDirectionalLight(0.6, -1.0, -0.4); }},
      {"DirectionalGrazing", [](Solids& scene) { scene.addDirectionalLight(1.0, -0.15, 0.2); }},
      {"SpotNarrow",
       [](Solids& scene) {
         addSpotLight(scene, {-1.0, 4.0, 1.0}, 25.0);
       }},
      {"SpotWide",
       [](Solids& scene) {
         addSpotLight(scene, {2.0, 2.5, 1.0}, 120.0);
       }},
      {"ThreeKinds",
       [](Solids& scene)
       {
         scene.addPointLight(2.5, 3.0, 1.5);
         scene.addDirectionalLight(0.6, -1.0, -0.4);
         addSpotLight(scene, {-2.0, 3.0, 2.0}, 60.0);
       },
       3},
      {"ParallelCamera",
       [](Solids& scene)
       {
         scene.renderer->GetActiveCamera()->ParallelProjectionOn();
         scene.renderer->GetActiveCamera()->SetParallelScale(1.4);
         scene.renderer->ResetCameraClippingRange();
         scene.addPointLight(0.5, 4.0, 1.5);
         scene.addDirectionalLight(0.6, -1.0, -0.4);
       },
       2},
  };
}

} // namespace

class SceneMasks : public testing::TestWithParam<LightCase>
{
};

TEST_P(SceneMasks, CameraOutsideShadows_EveryMethodIsRight)
{
  Solids scene;
  GetParam().addLights(scene);
  for (int light = 0; light < GetParam().lights; ++light)
  {
    SCOPED_TRACE("light " + std::to_string(light));
    expectTrueMaskByEveryMethod(scene, light);
  }
}

TEST_P(SceneMasks, MaskAndAdditive_GiveTheSameMask)
{
  Solids scene;
  GetParam().addLights(scene);
  for (int light = 0; light < GetParam().lights; ++light)
  {
    scene.pass->SetCompositingToMask();
    const std::vector<unsigned char> mask = scene.renderMask(light);
    scene.pass->SetCompositingToAdditive();
    EXPECT_EQ(scene.renderMask(light), mask) << "light " << light;
  }
}

INSTANTIATE_TEST_SUITE_P(Lights, SceneMasks, testing::ValuesIn(makeLightCases()),
                         [](const auto& test) { return std::string(test.param.name); });

} // namespace shadow::truth
