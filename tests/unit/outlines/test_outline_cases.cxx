// Outlines where it is hard, held against the truth.

#include <gtest/gtest.h>

#include <vtkCamera.h>
#include <vtkPlaneSource.h>
#include <vtkSphereSource.h>

#include "BallScene.h"
#include "OutlineCase.h"
#include "OutlineScene.h"
#include "TestMeshes.h"

using namespace shadow::test;
using shadow::truth::OutlineScene;

TEST(OutlineCase, PlaneSeenEdgeOn_OneLineAcross)
{
  OutlineScene scene(200, 150);
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-1.0, 0.0, -1.0);
  plane->SetPoint1(1.0, 0.0, -1.0);
  plane->SetPoint2(-1.0, 0.0, 1.0);
  scene.addSource(plane);
  setCamera(scene, {0.0, 0.0, 6.0}, {0.0, 0.0, 0.0});
  for (int technique = 0; technique < 2; ++technique)
  {
    scene.outlines->SetTechnique(technique);
    const Pixels lines = scene.renderLines(2.0);
    for (std::size_t x = 70; x < 130; ++x)
    {
      EXPECT_EQ(lines[200 * 74 + x], 255) << x;
      EXPECT_EQ(lines[200 * 75 + x], 255) << x;
      EXPECT_EQ(lines[200 * 72 + x], 0) << x;
      EXPECT_EQ(lines[200 * 77 + x], 0) << x;
    }
  }
}

TEST(OutlineCase, CameraInsideAMesh)
{
  OutlineScene scene(200, 150);
  scene.addPolyData(toPolyData(makeSphere(10.0, 24, 13)));
  scene.addPolyData(toPolyData(makeTorus(1.0, 0.4, 24, 12)));
  scene.addPolyData(toPolyData(makeCube({2.0, 0.5, -1.0}, 1.0)));
  setCamera(scene, {1.0, 1.5, 6.0}, {0.5, 0.0, 0.0});
  expectRight(scene);
}

TEST(OutlineCase, NearPlaneThroughTheMesh)
{
  OutlineScene scene(200, 150);
  scene.addPolyData(toPolyData(makeCube({0.0, 0.0, 0.0}, 2.0)));
  scene.addPolyData(toPolyData(makeTorus(2.5, 0.3, 24, 12)));
  setCamera(scene, {0.4, 0.6, 3.0}, {0.0, 0.0, 0.0}, 2.2);
  scene.renderer->GetActiveCamera()->SetViewAngle(80.0);
  expectRight(scene);
}

TEST(OutlineCase, FarPlane_NoLinesBeyondIt)
{
  OutlineScene scene(200, 150);
  scene.addPolyData(toPolyData(makeCube({-1.5, 0.0, 0.0}, 1.0)));
  scene.addPolyData(toPolyData(makeCube({1.5, 0.0, -4.0}, 1.0)));
  setCamera(scene, {0.0, 0.5, 8.0}, {0.0, 0.0, 0.0});
  for (int technique = 0; technique < 2; ++technique)
  {
    scene.outlines->SetTechnique(technique);
    for (const bool parallel : {false, true})
    {
      scene.renderer->GetActiveCamera()->SetParallelProjection(parallel);
      scene.renderer->GetActiveCamera()->SetParallelScale(2.5);
      scene.renderer->GetActiveCamera()->SetClippingRange(1.0, 20.0);
      const std::size_t both = countValue(scene.renderLines(2.0), 255);
      scene.renderer->GetActiveCamera()->SetClippingRange(1.0, 10.0);
      const Pixels lines = scene.renderLines(2.0);
      std::size_t right = 0;
      for (std::size_t i = 0; i < lines.size(); ++i)
      {
        right += i % 200 > 110 && lines[i] == 255 ? 1 : 0;
      }
      EXPECT_EQ(right, 0u) << parallel;
      EXPECT_GT(countValue(lines, 255), 100u) << parallel;
      EXPECT_GT(both, countValue(lines, 255) + 60u) << parallel;
    }
  }
}

TEST(OutlineCase, EyeBetweenTriangles_EdgesBehindIt)
{
  // Long triangles that pass the eye on all sides.
  OutlineScene scene(200, 150);
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-50.0, -1.0, 50.0);
  plane->SetPoint1(50.0, -1.0, 50.0);
  plane->SetPoint2(-50.0, -1.0, -10.0);
  scene.addSource(plane);
  plane->Update();
  scene.addPolyData(toPolyData(makeCube({0.5, 0.0, -3.0}, 1.5)));
  setCamera(scene, {0.0, 0.0, 0.0}, {0.0, -0.2, -1.0}, 0.01);
  expectRight(scene);
}

TEST(OutlineCase, TinyTriangles)
{
  OutlineScene scene(200, 150);
  scene.addPolyData(toPolyData(makeSphere(1.0, 300, 151)));
  setCamera(scene, {1.0, 2.0, 12.0}, {0.0, 0.0, 0.0});
  expectRight(scene);
}

TEST(OutlineCase, Needles)
{
  OutlineScene scene(200, 150);
  shadow::TriangleSoup needles = makeSphere(1.0, 64, 13);
  for (glm::dvec3& point : needles.points)
  {
    point.x *= 0.01;
  }
  scene.addPolyData(toPolyData(needles));
  setCamera(scene, {1.0, 0.5, 4.0}, {0.0, 0.0, 0.0});
  expectRight(scene, 0.97);
}

TEST(OutlineCase, NonManifoldEdges)
{
  OutlineScene scene(200, 150);
  scene.addPolyData(toPolyData(makeBook(5)));
  scene.addPolyData(toPolyData(makeCubesSharingAnEdge()));
  scene.lookFrom(0.4, 0.5, 1.0);
  expectRight(scene);
}

TEST(OutlineCase, Moebius)
{
  OutlineScene scene(200, 150);
  scene.addPolyData(toPolyData(makeMoebius(32)));
  scene.lookFrom(0.4, 0.9, 1.0);
  expectRight(scene);
}

TEST(OutlineCase, ScaledAndMirroredActors)
{
  OutlineScene scene(200, 150);
  vtkActor* torus = scene.addPolyData(toPolyData(makeTorus(1.0, 0.4, 24, 12)));
  torus->SetScale(-1.0, 0.5, 1.0);
  vtkActor* cube = scene.addPolyData(toPolyData(makeCube({0.0, 0.0, 0.0}, 1e-3)));
  cube->SetScale(1000.0, 2000.0, 500.0);
  cube->SetPosition(1.5, 0.0, 0.5);
  cube->RotateZ(30.0);
  scene.lookFrom(0.3, 0.5, 1.0);
  expectRight(scene);
}
