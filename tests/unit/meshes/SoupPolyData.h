#pragma once

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "SEDGeometry.h"

namespace shadow::test
{

/// The soup as VTK takes it, with points in double precision.
inline vtkSmartPointer<vtkPolyData> toPolyData(const TriangleSoup& soup)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const glm::dvec3& point : soup.points)
  {
    points->InsertNextPoint(point.x, point.y, point.z);
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& corners : soup.triangles)
  {
    triangles->InsertNextCell({corners[0], corners[1], corners[2]});
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(triangles);
  return data;
}

} // namespace shadow::test
