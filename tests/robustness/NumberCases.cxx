// How large the numbers are, and what transforms do to them.
#include <cmath>

#include <vtkActor.h>
#include <vtkMatrix4x4.h>

#include "HardCase.h"
#include "HardScene.h"

namespace shadow::robustness
{

namespace
{

/// A sphere with bumps of a hundredth of its radius, and a ring around it.
TriangleSoup bumpyMesh()
{
  TriangleSoup soup = test::makeSphere(1.0, 64, 32);
  for (glm::dvec3& point : soup.points)
  {
    point *= 1.0 + 0.01 * std::sin(40.0 * point.x) * std::sin(40.0 * point.y);
  }
  soup = moved(scaled(upright(soup), 0.6), {0.0, 1.1, 0.0});
  test::append(soup, moved(upright(test::makeTorus(1.1, 0.1, 64, 16)), {0.0, 1.0, 0.0}));
  return soup;
}

/// The usual scene, scaled and then moved, in its points.
void buildAt(HardScene& scene, double scale, const glm::dvec3& by)
{
  const auto place = [&](const TriangleSoup& soup) { scene.addMesh(moved(scaled(soup, scale), by)); };
  place(bumpyMesh());
  place(test::makeCube({-1.6, 0.4, 0.6}, 0.8));
  place(makeQuad({-4.0, 0.0, -4.0}, {0.0, 0.0, 8.0}, {8.0, 0.0, 0.0}));
  const glm::dvec3 light = by + scale * glm::dvec3(-2.1, 4.3, 2.7);
  scene.addPointLight(light.x, light.y, light.z);
  scene.addDirectionalLight(-0.53, -1.0, -0.31);
  scene.look(by + scale * glm::dvec3(2.5, 4.0, 6.5), by + scale * glm::dvec3(0.0, 0.4, 0.0));
}

void offsetTenMillion(HardScene& scene)
{
  buildAt(scene, 1.0, {1e7, -1e7, 1e7});
}

// The whole scene is a few hundredths wide.
void offsetTenMillionTinyDetails(HardScene& scene)
{
  buildAt(scene, 0.01, {1e7, 1e7, -1e7});
}

void offsetTenMillionOneAxis(HardScene& scene)
{
  buildAt(scene, 0.05, {0.0, 0.0, 1e7});
}

// Model coordinates around 0; the actors are far away.
void offsetTenMillionByActor(HardScene& scene)
{
  const glm::dvec3 by(1e7, -1e7, 2e7);
  for (vtkActor* actor :
       {scene.addMesh(bumpyMesh()), scene.addCube({-1.6, 0.0, 0.6}, 0.8), scene.addGround()})
  {
    actor->SetPosition(by.x, by.y, by.z);
  }
  scene.addPointLight(by.x - 2.1, by.y + 4.3, by.z + 2.7);
  scene.addDirectionalLight(-0.53, -1.0, -0.31);
  scene.look(by + glm::dvec3(2.5, 4.0, 6.5), by + glm::dvec3(0.0, 0.4, 0.0));
}

// Far away in the mesh, brought back by the actor.
void offsetTenMillionBroughtBack(HardScene& scene)
{
  const glm::dvec3 by(-1e7, 1e7, 1e7);
  scene.addMesh(moved(bumpyMesh(), by))->SetPosition(-by.x, -by.y, -by.z);
  scene.addCube({-1.6, 0.0, 0.6}, 0.8);
  scene.addGround();
  scene.addTwoLights();
  scene.lookAtGround();
}

void scaleOfAMillionth(HardScene& scene)
{
  buildAt(scene, 1e-6, {0.0, 0.0, 0.0});
}

void scaleOfABillion(HardScene& scene)
{
  buildAt(scene, 1e9, {0.0, 0.0, 0.0});
}

void buildScaledByActor(HardScene& scene, double scale)
{
  for (vtkActor* actor :
       {scene.addMesh(bumpyMesh()), scene.addCube({-1.6, 0.0, 0.6}, 0.8), scene.addGround()})
  {
    actor->SetScale(scale);
  }
  scene.addPointLight(-2.1 * scale, 4.3 * scale, 2.7 * scale);
  scene.addDirectionalLight(-0.53, -1.0, -0.31);
  scene.look(scale * glm::dvec3(2.5, 4.0, 6.5), scale * glm::dvec3(0.0, 0.4, 0.0));
}

void scaleOfAMillionthByActor(HardScene& scene)
{
  buildScaledByActor(scene, 1e-6);
}

void scaleOfABillionByActor(HardScene& scene)
{
  buildScaledByActor(scene, 1e9);
}

// A mesh in millionths, one in billions, side by side.
void mixedScales(HardScene& scene)
{
  scene.addMesh(moved(scaled(bumpyMesh(), 1e-6), {1e-6, 0.0, 0.0}))->SetScale(1e6);
  scene.addMesh(scaled(test::makeCube({-1.6, 0.4, 0.6}, 0.8), 1e9))->SetScale(1e-9);
  scene.addGround();
  scene.addTwoLights();
  scene.lookAtGround();
}

void finish(HardScene& scene)
{
  scene.addGround();
  scene.addTwoLights();
  scene.lookAtGround();
}

void mirroredTransform(HardScene& scene)
{
  vtkActor* mirrored = scene.addMesh(bumpyMesh());
  mirrored->SetScale(-1.0, 1.0, 1.0);
  scene.addMesh(moved(makeDome(0.6, 32), {-1.8, 0.3, 0.8}))->SetScale(-1.0, 1.0, 1.0);
  scene.addCube({-1.8, 0.0, 0.8}, 0.6);
  finish(scene);
}

void nonUniformTransform(HardScene& scene)
{
  vtkActor* actor = scene.addMesh(upright(test::makeTorus(0.7, 0.25, 48, 24)));
  actor->SetPosition(0.2, 1.0, 0.0);
  actor->SetScale(1.5, 0.3, 0.8);
  actor->RotateWXYZ(35.0, 1.0, 0.5, 0.2);
  scene.addMesh(moved(makeDome(0.6, 32), {-1.8, 0.3, 0.8}))->SetScale(0.9, 2.0, -1.1);
  finish(scene);
}

void shearTransform(HardScene& scene)
{
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 1, 0.7);
  matrix->SetElement(2, 1, -0.4);
  matrix->SetElement(0, 0, -1.2);
  matrix->SetElement(1, 2, 0.1);
  scene.addMesh(bumpyMesh())->SetUserMatrix(matrix);
  finish(scene);
}

void stronglyNonUniformTransform(HardScene& scene)
{
  vtkActor* actor = scene.addMesh(moved(scaled(test::makeSphere(1.0, 48, 24), 1e-3), {0.0, 2e-3, 0.0}));
  actor->SetScale(1e3, 400.0, 1.0);
  scene.addCube({-1.8, 0.0, 0.8}, 0.6);
  finish(scene);
}

// A sphere pressed into a disc. The light cannot be taken into the model, whose inside is gone: refused.
void flatteningTransform(HardScene& scene)
{
  vtkActor* actor = scene.addMesh(test::makeSphere(0.8, 48, 24));
  actor->SetPosition(0.3, 1.0, 0.0);
  actor->SetScale(1.0, 0.0, 1.0);
  scene.refused.push_back(actor);
  scene.addMesh(moved(upright(test::makeTorus(0.7, 0.25, 48, 24)), {-1.0, 0.9, 0.4}));
  finish(scene);
}

} // namespace

std::vector<HardCase> numberCases()
{
  return {
      {"OffsetTenMillion", offsetTenMillion},
      {"OffsetTenMillionTinyDetails", offsetTenMillionTinyDetails},
      {"OffsetTenMillionOneAxis", offsetTenMillionOneAxis},
      {"OffsetTenMillionByActor", offsetTenMillionByActor},
      {"OffsetTenMillionBroughtBack", offsetTenMillionBroughtBack},
      {"ScaleOfAMillionth", scaleOfAMillionth},
      {"ScaleOfABillion", scaleOfABillion},
      {"ScaleOfAMillionthByActor", scaleOfAMillionthByActor},
      {"ScaleOfABillionByActor", scaleOfABillionByActor},
      {"MixedScales", mixedScales},
      {"MirroredTransform", mirroredTransform},
      {"NonUniformTransform", nonUniformTransform},
      {"ShearTransform", shearTransform},
      {"StronglyNonUniformTransform", stronglyNonUniformTransform},
      {"FlatteningTransform", flatteningTransform, true, true, "flattens"},
  };
}

} // namespace shadow::robustness
