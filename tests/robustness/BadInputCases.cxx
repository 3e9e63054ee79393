// What has no right shadow: the pass leaves it out, says so where the user has to know, and draws the rest.
#include <limits>

#include <vtkCellArray.h>
#include <vtkPoints.h>

#include "HardCase.h"
#include "HardScene.h"

namespace shadow::robustness
{

namespace
{

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

void addSound(HardScene& scene)
{
  scene.addMesh(moved(upright(test::makeTorus(0.9, 0.35, 48, 24)), {0.0, 0.9, 0.0}));
  scene.addGround();
  scene.addTwoLights();
  scene.lookAtGround();
}

/// Above the ground, in view, and in the way of the light if it were a caster.
TriangleSoup plateOfBadPoint(const glm::dvec3& bad)
{
  TriangleSoup soup = makeGrid({-1.0, 2.0, -0.5}, {2.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, 4);
  soup.points[5] = bad;
  return soup;
}

void noPoints(HardScene& scene)
{
  addSound(scene);
  vtkNew<vtkPolyData> empty;
  scene.addPolyData(empty);
}

void pointsWithoutCells(HardScene& scene)
{
  addSound(scene);
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 2.0, 0.0);
  vtkNew<vtkPolyData> polyData;
  polyData->SetPoints(points);
  scene.addPolyData(polyData);
}

void onlyLinesAndVertices(HardScene& scene)
{
  addSound(scene);
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-1.0, 2.0, 0.0);
  points->InsertNextPoint(1.0, 2.0, 0.0);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({0, 1});
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({0});
  vtkNew<vtkPolyData> polyData;
  polyData->SetPoints(points);
  polyData->SetLines(lines);
  polyData->SetVerts(vertices);
  scene.addPolyData(polyData);
}

void actorWithoutMapper(HardScene& scene)
{
  addSound(scene);
  vtkNew<vtkActor> actor;
  scene.renderer->AddActor(actor);
}

void emptyScene(HardScene& scene)
{
  scene.addTwoLights();
}

void noLights(HardScene& scene)
{
  addSound(scene);
  scene.renderer->RemoveAllLights();
}

void nanCoordinate(HardScene& scene)
{
  addSound(scene);
  scene.refused.push_back(scene.addMesh(plateOfBadPoint({nan, 2.0, 0.0})));
}

void allCoordinatesNan(HardScene& scene)
{
  addSound(scene);
  TriangleSoup soup;
  soup.points.assign(3, glm::dvec3(nan));
  soup.triangles = {{0, 1, 2}};
  scene.refused.push_back(scene.addMesh(soup));
}

void infiniteCoordinate(HardScene& scene)
{
  addSound(scene);
  scene.refused.push_back(scene.addMesh(plateOfBadPoint({0.0, infinity, 0.0})));
}

void coordinateBeyondSinglePrecision(HardScene& scene)
{
  addSound(scene);
  scene.refused.push_back(scene.addMesh(plateOfBadPoint({0.0, 1e200, 0.0})));
}

void nanTransform(HardScene& scene)
{
  addSound(scene);
  vtkActor* actor = scene.addCube({0.0, 2.0, 0.0});
  actor->SetPosition(nan, 0.0, 0.0);
  scene.refused.push_back(actor);
}

void allTrianglesDegenerate(HardScene& scene)
{
  addSound(scene);
  TriangleSoup soup;
  soup.points = {{-1.0, 2.0, 0.0}, {1.0, 2.0, 0.0}};
  soup.triangles = {{0, 1, 1}, {0, 0, 0}};
  scene.addMesh(soup);
}

void lightWithoutDirection(HardScene& scene)
{
  addSound(scene);
  scene.addDirectionalLight(0.0, 0.0, 0.0);
  scene.refusedLights = {2};
}

void lightAtNan(HardScene& scene)
{
  addSound(scene);
  scene.addPointLight(nan, 2.0, 0.0);
  scene.refusedLights = {2};
}

void lightAtInfinity(HardScene& scene)
{
  addSound(scene);
  scene.addPointLight(0.0, infinity, 0.0);
  scene.refusedLights = {2};
}

void lightOfCone(HardScene& scene, double angle)
{
  addSound(scene);
  vtkLight* light = scene.addPointLight(1.5, 4.0, 1.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetConeAngle(angle);
}

void coneOf0(HardScene& scene)
{
  lightOfCone(scene, 0.0);
}

void coneOf90(HardScene& scene)
{
  lightOfCone(scene, 90.0);
}

void coneOf180(HardScene& scene)
{
  lightOfCone(scene, 180.0);
}

// The cone has no axis, the position is all a shadow needs.
void coneWithoutAxis(HardScene& scene)
{
  addSound(scene);
  vtkLight* light = scene.addPointLight(1.5, 4.0, 1.0);
  light->SetFocalPoint(1.5, 4.0, 1.0);
  light->SetConeAngle(40.0);
}

} // namespace

std::vector<HardCase> badInputCases()
{
  constexpr const char* notFinite = "is not finite";
  constexpr const char* noPlace = "it has no direction, or no finite position";
  return {
      {"NoPoints", noPoints},
      {"PointsWithoutCells", pointsWithoutCells},
      {"OnlyLinesAndVertices", onlyLinesAndVertices},
      {"ActorWithoutMapper", actorWithoutMapper},
      {"EmptyScene", emptyScene, true, false},
      {"NoLights", noLights, true, false},
      {"NanCoordinate", nanCoordinate, true, true, notFinite},
      {"AllCoordinatesNan", allCoordinatesNan, true, true, notFinite},
      {"InfiniteCoordinate", infiniteCoordinate, true, true, notFinite},
      {"CoordinateBeyondSinglePrecision", coordinateBeyondSinglePrecision, true, true, "single precision"},
      {"NanTransform", nanTransform, true, true, "finite"},
      {"AllTrianglesDegenerate", allTrianglesDegenerate, true, true, "degenerate"},
      {"LightWithoutDirection", lightWithoutDirection, true, true, noPlace},
      {"LightAtNan", lightAtNan, true, true, noPlace},
      {"LightAtInfinity", lightAtInfinity, true, true, noPlace},
      {"ConeOf0", coneOf0},
      {"ConeOf90", coneOf90},
      {"ConeOf180", coneOf180},
      {"ConeWithoutAxis", coneWithoutAxis},
  };
}

} // namespace shadow::robustness
