#include "OutlineMeshes.h"

#include <cstdio>
#include <filesystem>

#include <vtkAppendPolyData.h>
#include <vtkCleanPolyData.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkPolyData.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkTriangleFilter.h>

namespace shadow::benchmarks
{

Mesh clean(vtkAlgorithm* source)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkCleanPolyData> merged;
  merged->SetInputConnection(triangles->GetOutputPort());
  merged->Update();
  Mesh mesh = Mesh::New();
  mesh->SetPoints(merged->GetOutput()->GetPoints());
  mesh->SetPolys(merged->GetOutput()->GetPolys());
  return mesh;
}

Mesh makeRings()
{
  vtkNew<vtkParametricTorus> shape;
  shape->SetRingRadius(0.7);
  shape->SetCrossSectionRadius(0.28);
  vtkNew<vtkParametricFunctionSource> ring;
  ring->SetParametricFunction(shape);
  ring->SetUResolution(51);
  ring->SetVResolution(26);
  vtkNew<vtkAppendPolyData> rings;
  for (int i = 0; i < 12; ++i)
  {
    vtkNew<vtkTransform> place;
    place->Translate(1.7 * (i % 4), 1.5 * (i / 4 % 3), 0.6 * (i % 3));
    place->RotateY(40.0 * i);
    place->RotateX(25.0 * i);
    vtkNew<vtkTransformPolyDataFilter> placed;
    placed->SetTransform(place);
    placed->SetInputConnection(ring->GetOutputPort());
    rings->AddInputConnection(placed->GetOutputPort());
  }
  return clean(rings);
}

Mesh readModel(const std::string& name)
{
  const std::string file = std::string(MODEL_FOLDER) + "/" + name + ".obj";
  if (!std::filesystem::exists(file))
  {
    std::printf("%s is not there: left out\n", file.c_str());
    return nullptr;
  }
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(file.c_str());
  return clean(reader);
}

} // namespace shadow::benchmarks
