#include "MeshImport.h"

#include <vtkAOSDataArrayTemplate.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

namespace shadow
{

namespace
{

/// Without a virtual call for each where points are stored as most are.
void importPoints(vtkPoints* points, std::vector<glm::dvec3>& imported)
{
  imported.resize(static_cast<std::size_t>(points->GetNumberOfPoints()));
  if (auto* floats = vtkAOSDataArrayTemplate<float>::FastDownCast(points->GetData()))
  {
    const float* coordinate = floats->GetPointer(0);
    for (glm::dvec3& point : imported)
    {
      point = {coordinate[0], coordinate[1], coordinate[2]};
      coordinate += 3;
    }
    return;
  }
  for (std::size_t i = 0; i < imported.size(); ++i)
  {
    points->GetPoint(static_cast<vtkIdType>(i), &imported[i].x);
  }
}

void importPolygons(vtkCellArray* cells, std::vector<std::array<std::uint32_t, 3>>& triangles)
{
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  for (cells->InitTraversal(); cells->GetNextCell(size, corners) != 0;)
  {
    for (vtkIdType i = 1; i + 1 < size; ++i)
    {
      triangles.push_back({static_cast<std::uint32_t>(corners[0]), static_cast<std::uint32_t>(corners[i]),
                           static_cast<std::uint32_t>(corners[i + 1])});
    }
  }
}

void importStrips(vtkCellArray* cells, std::vector<std::array<std::uint32_t, 3>>& triangles)
{
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  for (cells->InitTraversal(); cells->GetNextCell(size, corners) != 0;)
  {
    for (vtkIdType i = 0; i + 2 < size; ++i)
    {
      const vtkIdType odd = i % 2;
      triangles.push_back({static_cast<std::uint32_t>(corners[i]),
                           static_cast<std::uint32_t>(corners[i + 1 + odd]),
                           static_cast<std::uint32_t>(corners[i + 2 - odd])});
    }
  }
}

} // namespace

TriangleSoup importTriangles(vtkPolyData* polyData)
{
  TriangleSoup soup;
  vtkPoints* points = polyData->GetPoints();
  if (points == nullptr)
  {
    return soup;
  }
  importPoints(points, soup.points);
  vtkCellArray* polygons = polyData->GetPolys();
  vtkCellArray* strips = polyData->GetStrips();
  const vtkIdType corners = polygons->GetNumberOfConnectivityIds() + strips->GetNumberOfConnectivityIds();
  const vtkIdType cells = polygons->GetNumberOfCells() + strips->GetNumberOfCells();
  soup.triangles.reserve(static_cast<std::size_t>(corners > 2 * cells ? corners - 2 * cells : 0));
  importPolygons(polygons, soup.triangles);
  importStrips(strips, soup.triangles);
  return soup;
}

} // namespace shadow
