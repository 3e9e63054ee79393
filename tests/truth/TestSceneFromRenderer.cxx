#include <gtest/gtest.h>

#include <stdexcept>

#include <vtkActor.h>
#include <vtkAssembly.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkDataSetMapper.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneSource.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPropAssembly.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include "CompositeMapper.h"
#include "SceneFromRenderer.h"
#include "TruthBvh.h"

using namespace shadow::truth;

namespace
{

/// A unit square in the xy plane, as one quadrilateral.
vtkSmartPointer<vtkActor> squareActor()
{
  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

double area(const Scene& scene)
{
  double sum = 0.0;
  for (const Triangle& t : scene.triangles)
  {
    sum += 0.5 * glm::length(glm::cross(t.b - t.a, t.c - t.a));
  }
  return sum;
}

Box bounds(const Scene& scene)
{
  Box box;
  for (const Triangle& t : scene.triangles)
  {
    box.add(t.a);
    box.add(t.b);
    box.add(t.c);
  }
  return box;
}

/// The squares of a renderer that holds one actor.
Scene sceneOf(vtkProp* prop)
{
  vtkNew<vtkRenderer> renderer;
  renderer->AddViewProp(prop);
  return sceneFromRenderer(renderer);
}

} // namespace

TEST(SceneFromRenderer, ActorMatrix_IsAppliedInDouble)
{
  auto actor = squareActor();
  actor->SetPosition(1e7, 0.25, -3.0);
  const Scene scene = sceneOf(actor);
  ASSERT_EQ(scene.triangles.size(), 2u);
  EXPECT_EQ(bounds(scene).low, glm::dvec3(1e7 - 0.5, -0.25, -3.0));
  EXPECT_EQ(bounds(scene).high, glm::dvec3(1e7 + 0.5, 0.75, -3.0));
}

TEST(SceneFromRenderer, NestedAssemblies_ComposeTheirMatrices)
{
  auto actor = squareActor();
  actor->SetPosition(1, 0, 0);
  vtkNew<vtkAssembly> inner;
  inner->AddPart(actor);
  inner->SetScale(2.0);
  vtkNew<vtkAssembly> outer;
  outer->AddPart(inner);
  outer->SetPosition(0, 0, 5);
  const Scene scene = sceneOf(outer);
  EXPECT_EQ(bounds(scene).low, glm::dvec3(1.0, -1.0, 5.0));
  EXPECT_EQ(bounds(scene).high, glm::dvec3(3.0, 1.0, 5.0));
}

TEST(SceneFromRenderer, OnlyOpaqueVisibleSurfaces)
{
  auto actor = squareActor();
  actor->VisibilityOff();
  EXPECT_TRUE(sceneOf(actor).triangles.empty());
  actor->VisibilityOn();
  actor->GetProperty()->SetOpacity(0.5);
  EXPECT_TRUE(sceneOf(actor).triangles.empty());
  actor->GetProperty()->SetOpacity(1.0);
  actor->GetProperty()->SetRepresentationToWireframe();
  EXPECT_TRUE(sceneOf(actor).triangles.empty());
  actor->GetProperty()->SetRepresentationToSurface();
  EXPECT_EQ(sceneOf(actor).triangles.size(), 2u);
  vtkNew<vtkActor> empty;
  EXPECT_TRUE(sceneOf(empty).triangles.empty());
}

TEST(SceneFromRenderer, InvisiblePropAssembly_HidesItsParts)
{
  vtkNew<vtkPropAssembly> inner, outer;
  inner->AddPart(squareActor());
  outer->AddPart(inner);
  EXPECT_EQ(sceneOf(outer).triangles.size(), 2u);
  inner->VisibilityOff();
  EXPECT_TRUE(sceneOf(outer).triangles.empty());
}

TEST(SceneFromRenderer, CullingFlags_GoIntoTheTriangles)
{
  auto actor = squareActor();
  actor->GetProperty()->BackfaceCullingOn();
  const Triangle triangle = sceneOf(actor).triangles.at(0);
  EXPECT_TRUE(triangle.hideBack);
  EXPECT_FALSE(triangle.hideFront);
  EXPECT_TRUE(triangle.casts);
}

TEST(SceneFromRenderer, Predicate_IsAskedAlongThePath)
{
  auto actor = squareActor();
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(actor);
  vtkNew<vtkRenderer> renderer;
  renderer->AddViewProp(assembly);
  for (vtkProp* excluded : {static_cast<vtkProp*>(actor), static_cast<vtkProp*>(assembly)})
  {
    const Scene scene = sceneFromRenderer(renderer, [&](vtkProp* prop) { return prop != excluded; });
    ASSERT_EQ(scene.triangles.size(), 2u);
    EXPECT_FALSE(scene.triangles[0].casts);
  }
}

TEST(SceneFromRenderer, StripsAndPolygons_AreCutAsVtkDrawsThem)
{
  vtkNew<vtkPoints> points;
  for (const glm::dvec2 p :
       {glm::dvec2(0, 0), {4, 0}, {4, 4}, {2, 1}, {0, 4}, {10, 0}, {11, 0}, {10, 1}, {11, 1}})
  {
    points->InsertNextPoint(p.x, p.y, 0.0);
  }
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  vtkNew<vtkCellArray> polygons, strips;
  // VTK draws fans around the first corner, so a concave polygon has to start at its notch.
  polygons->InsertNextCell({3, 4, 0, 1, 2});
  strips->InsertNextCell({5, 6, 7, 8});
  mesh->SetPolys(polygons);
  mesh->SetStrips(strips);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  const Scene scene = sceneOf(actor);
  EXPECT_EQ(scene.triangles.size(), 5u);
  EXPECT_DOUBLE_EQ(area(scene), 10.0 + 1.0);
  for (const Triangle& t : scene.triangles)
  {
    EXPECT_GT(glm::cross(t.b - t.a, t.c - t.a).z, 0.0);
  }
}

TEST(SceneFromRenderer, DataSetMapper_GivesTheSurface)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputData(image);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  EXPECT_DOUBLE_EQ(area(sceneOf(actor)), 24.0);
}

TEST(SceneFromRenderer, CompositeMapper_LeavesHiddenBlocksOut)
{
  vtkNew<vtkMultiBlockDataSet> root, group;
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkPlaneSource> plane;
    plane->Update();
    group->SetBlock(i, plane->GetOutput());
  }
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  root->SetBlock(0, group);
  root->SetBlock(1, sphere->GetOutput());
  vtkNew<CompositeMapper> mapper;
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  mapper->SetInputDataObject(root);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  const std::size_t all = sceneOf(actor).triangles.size();
  EXPECT_GT(all, 4u);
  attributes->SetBlockVisibility(group, false);
  EXPECT_EQ(sceneOf(actor).triangles.size(), all - 4u);
  attributes->SetBlockVisibility(group->GetBlock(1), true);
  EXPECT_EQ(sceneOf(actor).triangles.size(), all - 2u);
}

TEST(SceneFromRenderer, ClippingPlane_CutsInWorldSpace)
{
  auto actor = squareActor();
  actor->SetPosition(10, 0, 0);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(10.25, 0, 0);
  plane->SetNormal(1, 0, 0);
  actor->GetMapper()->AddClippingPlane(plane);
  const Scene scene = sceneOf(actor);
  EXPECT_NEAR(area(scene), 0.25, 1e-12);
  EXPECT_NEAR(bounds(scene).low.x, 10.25, 1e-12);
  plane->SetOrigin(11, 0, 0);
  EXPECT_TRUE(sceneOf(actor).triangles.empty());
}

TEST(SceneFromRenderer, MapperThatDrawsSomethingElse_Throws)
{
  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  EXPECT_THROW(sceneOf(actor), std::invalid_argument);
}

TEST(SceneFromRenderer, View_ProjectsAsTheCamera)
{
  vtkNew<vtkCamera> camera;
  camera->SetPosition(1, 2, 3);
  camera->SetFocalPoint(0, 0.5, 0);
  camera->SetClippingRange(0.5, 30.0);
  const View view = viewFromCamera(camera, 200, 100);
  const glm::dvec4 clip = view.clipFromWC * glm::dvec4(0, 0.5, 0, 1);
  EXPECT_NEAR(clip.x, 0.0, 1e-12);
  EXPECT_NEAR(clip.y, 0.0, 1e-12);
  EXPECT_NEAR(clip.w, camera->GetDistance(), 1e-12);

  vtkNew<vtkRenderer> renderer;
  renderer->SetActiveCamera(camera);
  renderer->SetViewport(0.5, 0.0, 1.0, 0.25);
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetSize(400, 400);
  window->AddRenderer(renderer);
  const View same = viewFromRenderer(renderer);
  EXPECT_EQ(same.width, 200);
  EXPECT_EQ(same.height, 100);
  EXPECT_EQ(same.clipFromWC, view.clipFromWC);
}

TEST(SceneFromRenderer, Lights_InOrderWithoutThoseSwitchedOff)
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkLight> point, off, sun, head;
  point->SetPositional(true);
  point->SetPosition(1, 2, 3);
  off->SwitchOff();
  sun->SetPosition(0, 0, 8);
  sun->SetFocalPoint(0, 0, 3);
  head->SetLightTypeToHeadlight();
  for (vtkLight* light : {point.Get(), off.Get(), sun.Get(), head.Get()})
  {
    renderer->AddLight(light);
  }
  const std::vector<RendererLight> lights = lightsFromRenderer(renderer);
  ASSERT_EQ(lights.size(), 3u);
  EXPECT_EQ(lights[0].light.positionWC, glm::dvec4(1, 2, 3, 1));
  EXPECT_EQ(lights[1].light.positionWC, glm::dvec4(0, 0, 1, 0));
  EXPECT_TRUE(lights[0].casts && lights[1].casts);
  EXPECT_FALSE(lights[2].casts);
  EXPECT_EQ(lights[2].source, head.Get());
}
