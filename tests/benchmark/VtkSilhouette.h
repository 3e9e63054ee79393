#pragma once

#include <vector>

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataSilhouette.h>

#include "SEDGeometry.h"
#include "Timing.h"

namespace shadow::benchmarks
{

/// vtkPolyDataSilhouette, prepared: it has seen its input.
class VtkSilhouette
{
public:
  explicit VtkSilhouette(const TriangleSoup& soup)
  {
    vtkNew<vtkPoints> points;
    for (const glm::dvec3& point : soup.points)
    {
      points->InsertNextPoint(&point.x);
    }
    vtkNew<vtkCellArray> triangles;
    for (const auto& corners : soup.triangles)
    {
      triangles->InsertNextCell({corners[0], corners[1], corners[2]});
    }
    vtkNew<vtkPolyData> mesh;
    mesh->SetPoints(points);
    mesh->SetPolys(triangles);
    this->filter->SetInputData(mesh);
    this->filter->SetDirectionToSpecifiedOrigin();
    this->filter->SetEnableFeatureAngle(0);
    this->filter->Update();
  }

  void measureOnce(const glm::dvec3& lightWC)
  {
    this->filter->SetOrigin(lightWC.x, lightWC.y, lightWC.z);
    this->milliseconds.push_back(measure([&] { this->filter->Update(); }));
  }

  double getMedian() const { return median(this->milliseconds); }

private:
  vtkNew<vtkPolyDataSilhouette> filter;
  std::vector<double> milliseconds;
};

} // namespace shadow::benchmarks
