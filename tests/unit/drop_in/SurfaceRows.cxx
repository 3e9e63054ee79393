#include <vtkAssembly.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkElevationFilter.h>
#include <vtkFloatArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

#include "DropInCase.h"

// Actors of meshes, and what their properties and mappers can be set to.
namespace shadow::test
{

namespace
{

/// A row that sets something of the ball.
template <class Set>
Row ball(const char* name, Set set)
{
  return {name, [set](DropInScene& scene) { set(scene.ballActor, scene.ballActor->GetProperty()); }};
}

/// The ball's mesh, to be changed.
vtkSmartPointer<vtkPolyData> copyBall(DropInScene& scene)
{
  scene.ball->Update();
  const auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(scene.ball->GetOutput());
  return copy;
}

void showInstead(DropInScene& scene, vtkPolyData* mesh)
{
  vtkPolyDataMapper::SafeDownCast(scene.ballActor->GetMapper())->SetInputData(mesh);
}

/// Vertices, lines, polygons and strips in one mesh, each beside the other.
void addMixed(DropInScene& scene)
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 16; ++i)
  {
    points->InsertNextPoint(-1.6 + 0.2 * i, 0.2 + 0.3 * (i % 2), 1.2);
  }
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkCellArray> strips;
  vertices->InsertNextCell({0, 1, 2});
  lines->InsertNextCell({3, 4, 5});
  lines->InsertNextCell({5, 3});
  polygons->InsertNextCell({6, 8, 9, 7});
  polygons->InsertNextCell({8, 10, 9});
  strips->InsertNextCell({11, 12, 13, 14, 15});
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetVerts(vertices);
  mesh->SetLines(lines);
  mesh->SetPolys(polygons);
  mesh->SetStrips(strips);
  vtkActor* actor = scene.addPolyData(mesh);
  actor->GetProperty()->SetColor(0.2, 0.8, 0.3);
  actor->GetProperty()->SetPointSize(7.0f);
  actor->GetProperty()->SetLineWidth(3.0f);
}

void colour(DropInScene& scene, bool ofCells, int components)
{
  const vtkSmartPointer<vtkPolyData> mesh = copyBall(scene);
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(components);
  const vtkIdType count = ofCells ? mesh->GetNumberOfCells() : mesh->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double values[4] = {25.0 * (i % 10), 255.0 - 17.0 * (i % 15), 40.0 * (i % 6),
                              80.0 + 50.0 * (i % 3)};
    colours->InsertNextTuple(values);
  }
  (ofCells ? static_cast<vtkDataSetAttributes*>(mesh->GetCellData()) : mesh->GetPointData())
      ->SetScalars(colours);
  showInstead(scene, mesh);
}

void elevate(DropInScene& scene, bool interpolate)
{
  vtkNew<vtkElevationFilter> elevation;
  elevation->SetInputConnection(scene.ball->GetOutputPort());
  elevation->SetLowPoint(0.0, 0.5, 0.0);
  elevation->SetHighPoint(0.0, 1.5, 0.0);
  scene.ballActor->GetMapper()->SetInputConnection(elevation->GetOutputPort());
  scene.ballActor->GetMapper()->SetInterpolateScalarsBeforeMapping(interpolate);
}

void moveFarAway(DropInScene& scene)
{
  const vtkSmartPointer<vtkPolyData> mesh = copyBall(scene);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* point = mesh->GetPoint(i);
    points->InsertNextPoint(point[0] + 1e6, point[1], point[2]);
  }
  mesh->SetPoints(points);
  showInstead(scene, mesh);
  scene.ballActor->SetPosition(-1e6, 0.0, 0.0);
}

void shear(DropInScene& scene)
{
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 1, 0.4);
  matrix->SetElement(1, 1, 0.7);
  scene.ballActor->SetUserMatrix(matrix);
}

void clip(DropInScene& scene)
{
  for (const double side : {-1.0, 1.0})
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(side * 0.3, 1.0, 0.0);
    plane->SetNormal(-side, 0.3, -0.2);
    scene.ballActor->GetMapper()->AddClippingPlane(plane);
  }
}

void spoilNormals(DropInScene& scene)
{
  const vtkSmartPointer<vtkPolyData> mesh = copyBall(scene);
  mesh->GetPointData()->SetNormals(nullptr);
  showInstead(scene, mesh);
}

void pullTowardsTheEye(DropInScene& scene)
{
  vtkActor* sheet = addBox(scene, 1.0, 0.5);
  sheet->SetScale(1.0, 1e-9, 1.0);
  sheet->GetMapper()->SetResolveCoincidentTopologyToPolygonOffset();
  sheet->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(-2.0, -4.0);
}

void shadeOtherwise(DropInScene& scene)
{
  scene.ballActor->GetShaderProperty()->AddFragmentShaderReplacement(
      "//VTK::Light::Impl", true, "//VTK::Light::Impl\n  gl_FragData[0].rgb = 1.0 - gl_FragData[0].rgb;\n",
      false);
}

void textureBall(DropInScene& scene)
{
  const vtkSmartPointer<vtkPolyData> mesh = copyBall(scene);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* point = mesh->GetPoint(i);
    coordinates->InsertNextTuple2(0.5 + point[0], point[1] - 0.5);
  }
  mesh->GetPointData()->SetTCoords(coordinates);
  showInstead(scene, mesh);
  scene.ballActor->SetTexture(makeTexture());
}

/// Colours with an alpha of a half, in an actor that is to be drawn as opaque, in an assembly.
void forceColoursInAssembly(DropInScene& scene)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(-0.5, 0.8, 0.9);
  sphere->Update();
  vtkPolyData* ball = sphere->GetOutput();
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(4);
  for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); ++i)
  {
    colours->InsertNextTuple4(200.0, 40.0, 90.0, 128.0);
  }
  ball->GetPointData()->SetScalars(colours);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(ball);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->ForceOpaqueOn();
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(actor);
  scene.renderer->AddActor(assembly);
}

} // namespace

std::vector<Row> surfaceRows()
{
  using P = vtkProperty;
  return {
      {"surface", [](DropInScene&) {}},
      ball("wireframe", [](vtkActor*, P* of) { of->SetRepresentationToWireframe(); }),
      ball("wireframe_wide",
           [](vtkActor*, P* of) { of->SetRepresentationToWireframe(), of->SetLineWidth(4.0f); }),
      ball("points", [](vtkActor*, P* of) { of->SetRepresentationToPoints(); }),
      ball("points_large", [](vtkActor*, P* of) { of->SetRepresentationToPoints(), of->SetPointSize(6.0f); }),
      ball("points_as_spheres", [](vtkActor*, P* of)
           { of->SetRepresentationToPoints(), of->SetPointSize(8.0f), of->RenderPointsAsSpheresOn(); }),
      ball("lines_as_tubes", [](vtkActor*, P* of)
           { of->SetRepresentationToWireframe(), of->SetLineWidth(5.0f), of->RenderLinesAsTubesOn(); }),
      ball("flat", [](vtkActor*, P* of) { of->SetInterpolationToFlat(); }),
      ball("gouraud", [](vtkActor*, P* of) { of->SetInterpolationToGouraud(); }),
      ball("phong_specular", [](vtkActor*, P* of)
           { of->SetInterpolationToPhong(), of->SetSpecular(0.6), of->SetSpecularPower(20.0); }),
      ball("physically_based", [](vtkActor*, P* of)
           { of->SetInterpolationToPBR(), of->SetMetallic(0.5), of->SetRoughness(0.3); }),
      ball("edges", [](vtkActor*, P* of)
           { of->EdgeVisibilityOn(), of->SetEdgeColor(1, 1, 0), of->SetLineWidth(2.0f); }),
      ball("edges_as_tubes", [](vtkActor*, P* of)
           { of->EdgeVisibilityOn(), of->RenderLinesAsTubesOn(), of->SetLineWidth(3.0f); }),
      ball("vertices",
           [](vtkActor*, P* of) {
             of->EdgeVisibilityOn(), of->VertexVisibilityOn(), of->SetVertexColor(1, 0, 0),
                 of->SetPointSize(4.0f);
           }),
      ball("lighting_off", [](vtkActor*, P* of) { of->LightingOff(); }),
      ball("ambient_only", [](vtkActor*, P* of) { of->SetAmbient(0.7), of->SetDiffuse(0.0); }),
      ball("backs_culled", [](vtkActor*, P* of) { of->BackfaceCullingOn(); }),
      ball("fronts_culled", [](vtkActor*, P* of) { of->FrontfaceCullingOn(); }),
      ball("mirrored", [](vtkActor* actor, P*) { actor->SetScale(-1.0, 1.0, 0.6); }),
      ball("invisible", [](vtkActor* actor, P*) { actor->VisibilityOff(); }),
      ball("force_opaque", [](vtkActor* actor, P* of) { of->SetOpacity(0.5), actor->ForceOpaqueOn(); }),
      {"force_opaque_by_colours_in_an_assembly", forceColoursInAssembly},
      {"back_property",
       [](DropInScene& scene)
       {
         vtkNew<vtkProperty> back;
         back->SetColor(0.9, 0.1, 0.8);
         scene.ballActor->SetBackfaceProperty(back);
         clip(scene);
       }},
      {"without_normals", spoilNormals},
      {"half_ball_smooth",
       [](DropInScene& scene)
       {
         scene.ball->SetThetaResolution(8);
         scene.ball->SetPhiResolution(5);
         scene.ball->SetEndTheta(200.0);
       }},
      {"mixed_cells", addMixed},
      {"sheared", shear},
      {"far_away", moveFarAway},
      {"clipped", clip},
      {"pulled_towards_the_eye", pullTowardsTheEye},
      {"shader_of_its_own", shadeOtherwise, nullptr, wholeWays}, // what it does is no sum over lights
      {"texture", [](DropInScene& scene) { scene.table->SetTexture(makeTexture()); }},
      {"texture_on_a_ball", textureBall},
      {"texture_of_holes", [](DropInScene& scene) { scene.table->SetTexture(makeTextureOfHoles()); }},
      {"point_colours", [](DropInScene& scene) { colour(scene, false, 3); }},
      {"cell_colours", [](DropInScene& scene) { colour(scene, true, 3); }},
      {"translucent_colours", [](DropInScene& scene) { colour(scene, false, 4); }},
      {"scalars", [](DropInScene& scene) { elevate(scene, false); }},
      {"scalars_interpolated", [](DropInScene& scene) { elevate(scene, true); }},
      {"no_props", [](DropInScene& scene) { scene.renderer->RemoveAllViewProps(); }},
  };
}

} // namespace shadow::test
