#include "MeshCheck.h"

#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkGenericCell.h>
#include <vtkMergePoints.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkStructuredGrid.h>
#include <vtkTriangle.h>
#include <vtkTriangleFilter.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "../../../plugin/vtkShadowCompat.h"

namespace shadow::examples
{
namespace
{

// Normals and edge lengths are squared in single precision on their way through the GL.
constexpr double LARGEST = 1e18;

std::string findDamagedPoint(vtkDataSet* data)
{
  for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id)
  {
    double point[3];
    data->GetPoint(id, point);
    for (const double coordinate : point)
    {
      if (!std::isfinite(coordinate))
      {
        return "point " + std::to_string(id + 1) + " is not finite";
      }
      if (std::abs(coordinate) > LARGEST)
      {
        return "point " + std::to_string(id + 1) + " is too far away (over 1e18)";
      }
    }
  }
  return {};
}

std::string findDamagedCell(vtkCellArray* cells, vtkIdType points)
{
  if (cells->GetNumberOfCells() > 0 && cells->GetOffsetsArray()->GetComponent(0, 0) != 0.0)
  {
    return "its cells do not begin at the first point";
  }
  vtkIdType end = 0;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    // the offsets first: they say where the cell's own points lie
    const vtkIdType size = cells->GetCellSize(cell);
    end += size;
    if (size < 0 || end > cells->GetNumberOfConnectivityIds())
    {
      return "cell " + std::to_string(cell + 1) + " has a wrong number of points";
    }
  }
  const auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (ids[i] < 0 || ids[i] >= points)
      {
        return "cell " + std::to_string(iterator->GetCurrentCellId() + 1) +
               " uses a point that does not exist";
      }
    }
  }
  return {};
}

// Cells of a fixed kind that have too few points make the surface filter read beyond them.
std::string findWrongCellType(vtkUnstructuredGrid* grid)
{
  if (grid->GetNumberOfCells() > 0 &&
      (VTKSHADOW_CELL_TYPES(grid) == nullptr ||
       VTKSHADOW_CELL_TYPES(grid)->GetNumberOfTuples() != grid->GetNumberOfCells()))
  {
    return "not every cell has a type";
  }
  int type = -1;
  vtkSmartPointer<vtkCell> pattern;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (grid->GetCellType(cell) != type)
    {
      type = grid->GetCellType(cell);
      pattern = vtk::TakeSmartPointer(vtkGenericCell::InstantiateCell(type));
    }
    const vtkIdType size = grid->GetCells()->GetCellSize(cell);
    if (!pattern || (pattern->GetNumberOfPoints() > 0 && pattern->GetNumberOfPoints() != size))
    {
      return "cell " + std::to_string(cell + 1) + " does not fit its type";
    }
  }
  return {};
}

bool allFinite(vtkDataArray* array)
{
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int component = 0; component < array->GetNumberOfComponents(); ++component)
    {
      if (!std::isfinite(array->GetComponent(i, component)))
      {
        return false;
      }
    }
  }
  return true;
}

bool areColours(vtkDataArray* array)
{
  return vtkUnsignedCharArray::SafeDownCast(array) != nullptr && array->GetNumberOfComponents() >= 3 &&
         array->GetNumberOfComponents() <= 4;
}

// Gives triangles that meet at equal coordinates a common point, so that they are shaded as one surface:
// vtkOBJReader hands out every corner on its own when texture coordinates are numbered in another way than
// points.
vtkSmartPointer<vtkPolyData> weld(vtkPolyData* mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  vtkNew<vtkMergePoints> locator;
  locator->InitPointInsertion(points, mesh->GetBounds(), mesh->GetNumberOfPoints());
  std::vector<vtkIdType> newIds(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (vtkIdType id = 0; id < mesh->GetNumberOfPoints(); ++id)
  {
    locator->InsertUniquePoint(mesh->GetPoint(id), newIds[static_cast<std::size_t>(id)]);
  }
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(mesh->GetNumberOfPolys(), 3 * mesh->GetNumberOfPolys());
  const auto iterator = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(size, ids);
    triangles->InsertNextCell({newIds[ids[0]], newIds[ids[1]], newIds[ids[2]]});
  }
  auto welded = vtkSmartPointer<vtkPolyData>::New();
  welded->SetPoints(points);
  welded->SetPolys(triangles);
  welded->GetCellData()->SetScalars(mesh->GetCellData()->GetScalars());
  return welded;
}

vtkSmartPointer<vtkPolyData> withNormals(vtkPolyData* mesh)
{
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  if (normals != nullptr && normals->GetNumberOfTuples() == mesh->GetNumberOfPoints() && allFinite(normals))
  {
    return mesh;
  }
  const bool pointColours = mesh->GetPointData()->GetScalars() != nullptr; // they may differ at one place
  vtkNew<vtkPolyDataNormals> filter;
  filter->SetInputData(pointColours ? vtkSmartPointer<vtkPolyData>(mesh) : weld(mesh));
  filter->SetFeatureAngle(30.0);
  filter->SplittingOn();
  filter->ConsistencyOff(); // the winding is the mesh's own
  filter->Update();
  return filter->GetOutput();
}

} // namespace

std::string findDamage(vtkDataSet* data)
{
  const vtkIdType points = data->GetNumberOfPoints();
  std::string damage;
  if (auto* mesh = vtkPolyData::SafeDownCast(data))
  {
    for (vtkCellArray* cells : {mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips()})
    {
      damage = damage.empty() && cells != nullptr ? findDamagedCell(cells, points) : damage;
    }
  }
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    damage = grid->GetCells() != nullptr ? findDamagedCell(grid->GetCells(), points) : "";
    damage = damage.empty() ? findWrongCellType(grid) : damage;
  }
  else if (auto* structured = vtkStructuredGrid::SafeDownCast(data))
  {
    int size[3];
    structured->GetDimensions(size);
    const double expected = static_cast<double>(size[0]) * size[1] * size[2];
    damage = expected == static_cast<double>(points) ? "" : "its points do not fit its dimensions";
  }
  return damage.empty() ? findDamagedPoint(data) : damage;
}

vtkSmartPointer<vtkPolyData> extractTriangles(vtkDataSet* data)
{
  vtkSmartPointer<vtkPolyData> surface = vtkPolyData::SafeDownCast(data);
  if (!surface)
  {
    vtkNew<vtkDataSetSurfaceFilter> filter;
    filter->SetInputData(data);
    filter->Update();
    surface = filter->GetOutput();
  }

  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->SetInputData(surface);
  triangulate->PassVertsOff();
  triangulate->PassLinesOff();
  triangulate->Update();
  vtkPolyData* triangles = triangulate->GetOutput();

  // Arrays that are not colours would otherwise colour the surface through the mapper.
  vtkNew<vtkPolyData> plain;
  plain->SetPoints(triangles->GetPoints());
  plain->SetPolys(triangles->GetPolys());
  plain->GetPointData()->SetNormals(triangles->GetPointData()->GetNormals());
  if (areColours(triangles->GetPointData()->GetScalars()))
  {
    plain->GetPointData()->SetScalars(triangles->GetPointData()->GetScalars());
  }
  else if (areColours(triangles->GetCellData()->GetScalars()))
  {
    plain->GetCellData()->SetScalars(triangles->GetCellData()->GetScalars());
  }
  return plain->GetNumberOfPolys() > 0 ? withNormals(plain) : vtkSmartPointer<vtkPolyData>(plain);
}

bool hasArea(vtkPolyData* triangles)
{
  const auto iterator = vtk::TakeSmartPointer(triangles->GetPolys()->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(size, ids);
    double corners[3][3];
    for (int i = 0; i < 3; ++i)
    {
      triangles->GetPoint(ids[i], corners[i]);
    }
    double normal[3];
    vtkTriangle::ComputeNormalDirection(corners[0], corners[1], corners[2], normal);
    if (normal[0] != 0.0 || normal[1] != 0.0 || normal[2] != 0.0)
    {
      return true;
    }
  }
  return false;
}

} // namespace shadow::examples
