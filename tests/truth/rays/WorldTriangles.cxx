#include "WorldTriangles.h"

#include <stdexcept>
#include <string>

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkClipPolyData.h>
#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkDataObjectTree.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkDataSetMapper.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkSmartPointer.h>

#include "CompositeMapper.h"

namespace shadow::truth
{

namespace
{

/// Takes the data sets of one mapper apart into world triangles.
class TriangleAppender
{
public:
  TriangleAppender(vtkMapper* theMapper, const glm::dmat4& theMatrix, const Triangle& theStyle,
                   Scene& theScene)
      : mapper(theMapper), worldFromMC(theMatrix), style(theStyle), scene(theScene)
  {
    if (auto* composite = CompositeMapper::SafeDownCast(theMapper))
    {
      this->attributes = composite->GetCompositeDataDisplayAttributes();
    }
  }

  /// @param visible  what the block inherits from the blocks it lies in
  void append(vtkDataObject* data, bool visible)
  {
    if (this->attributes && this->attributes->HasBlockVisibility(data))
    {
      visible = this->attributes->GetBlockVisibility(data);
    }
    if (auto* tree = vtkDataObjectTree::SafeDownCast(data))
    {
      vtkSmartPointer<vtkDataObjectTreeIterator> children;
      children.TakeReference(tree->NewTreeIterator());
      children->TraverseSubTreeOff();
      children->VisitOnlyLeavesOff();
      for (children->InitTraversal(); !children->IsDoneWithTraversal(); children->GoToNextItem())
      {
        this->append(children->GetCurrentDataObject(), visible);
      }
    }
    else if (auto* mesh = vtkPolyData::SafeDownCast(data); mesh && visible)
    {
      this->appendMesh(mesh);
    }
    else if (vtkDataSet::SafeDownCast(data) && visible)
    {
      vtkNew<vtkDataSetSurfaceFilter> surface;
      surface->SetInputData(data);
      surface->Update();
      this->appendMesh(surface->GetOutput());
    }
  }

private:
  void appendMesh(vtkPolyData* mesh)
  {
    vtkSmartPointer<vtkPolyData> triangles = this->inWorld(mesh);
    vtkPlaneCollection* planes = this->mapper->GetClippingPlanes();
    for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
    {
      vtkNew<vtkClipPolyData> clip;
      clip->SetInputData(triangles);
      clip->SetClipFunction(planes->GetItem(i));
      clip->Update();
      // A clipped triangle can become a quadrilateral.
      const auto clipped = vtkSmartPointer<vtkPolyData>::New();
      clipped->SetPoints(clip->GetOutput()->GetPoints());
      clipped->SetPolys(cutIntoTriangles(clip->GetOutput()));
      triangles = clipped;
    }
    this->appendPolygons(triangles);
  }

  static vtkSmartPointer<vtkCellArray> cutIntoTriangles(vtkPolyData* mesh)
  {
    const auto triangles = vtkSmartPointer<vtkCellArray>::New();
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    auto cells = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
    for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
    {
      cells->GetCurrentCell(count, ids);
      for (vtkIdType i = 2; i < count; ++i)
      {
        triangles->InsertNextCell({ids[0], ids[i - 1], ids[i]});
      }
    }
    cells = vtk::TakeSmartPointer(mesh->GetStrips()->NewIterator());
    for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
    {
      cells->GetCurrentCell(count, ids);
      for (vtkIdType i = 2; i < count; ++i)
      {
        // Every second triangle of a strip is wound the other way.
        const bool even = i % 2 == 0;
        triangles->InsertNextCell({ids[i - 2], ids[even ? i - 1 : i], ids[even ? i : i - 1]});
      }
    }
    return triangles;
  }

  vtkSmartPointer<vtkPolyData> inWorld(vtkPolyData* mesh) const
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(mesh->GetNumberOfPoints());
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      glm::dvec4 p(1.0);
      mesh->GetPoint(i, &p[0]);
      p.w = 1.0;
      p = this->worldFromMC * p;
      points->SetPoint(i, p.x / p.w, p.y / p.w, p.z / p.w);
    }
    auto world = vtkSmartPointer<vtkPolyData>::New();
    world->SetPoints(points);
    world->SetPolys(cutIntoTriangles(mesh));
    return world;
  }

  void appendPolygons(vtkPolyData* triangles)
  {
    const std::uint32_t part = this->scene.triangles.empty() ? 0 : this->scene.triangles.back().part + 1;
    auto cells = vtk::TakeSmartPointer(triangles->GetPolys()->NewIterator());
    for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      cells->GetCurrentCell(count, ids);
      if (count == 3)
      {
        Triangle triangle = this->style;
        triangle.part = part;
        triangles->GetPoint(ids[0], &triangle.a[0]);
        triangles->GetPoint(ids[1], &triangle.b[0]);
        triangles->GetPoint(ids[2], &triangle.c[0]);
        this->scene.triangles.push_back(triangle);
      }
    }
  }

  vtkMapper* mapper;
  vtkCompositeDataDisplayAttributes* attributes = nullptr;
  const glm::dmat4& worldFromMC;
  const Triangle& style;
  Scene& scene;
};

bool drawsItsSurface(vtkMapper* mapper)
{
  return vtkPolyDataMapper::SafeDownCast(mapper) || vtkDataSetMapper::SafeDownCast(mapper) ||
         CompositeMapper::SafeDownCast(mapper) || mapper->IsA("vtkCompositePolyDataMapper");
}

} // namespace

glm::dmat4 toGlm(vtkMatrix4x4* matrix)
{
  glm::dmat4 result;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      result[column][row] = matrix->GetElement(row, column);
    }
  }
  return result;
}

void appendWorldTriangles(vtkMapper* mapper, const glm::dmat4& worldFromMC, const Triangle& style,
                          Scene& scene)
{
  if (!drawsItsSurface(mapper))
  {
    throw std::invalid_argument(std::string("no ray-cast truth for what this mapper draws: ") +
                                mapper->GetClassName());
  }
  vtkDataObject* data = mapper->GetInputDataObject(0, 0);
  if (data)
  {
    TriangleAppender(mapper, worldFromMC, style, scene).append(data, true);
  }
}

} // namespace shadow::truth
