#include "RefinedMesh.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <queue>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

namespace shadow::benchmarks
{

namespace
{

using Index = vtkIdType;
using Ends = std::pair<Index, Index>; ///< the smaller one first

class Refiner
{
public:
  explicit Refiner(vtkPolyData* mesh)
  {
    for (Index i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      this->points.emplace_back();
      mesh->GetPoint(i, &this->points.back()[0]);
    }
    auto cells = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
    for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
    {
      Index count = 0;
      const Index* ids = nullptr;
      cells->GetCurrentCell(count, ids);
      for (Index i = 2; i < count; ++i)
      {
        this->addTriangle({ids[0], ids[i - 1], ids[i]});
      }
    }
  }

  std::size_t countTriangles() const { return this->triangles.size(); }

  /// Halves the longest edge that has at most so many triangles. False: there is none.
  bool halve(std::size_t mostTriangles)
  {
    std::vector<std::pair<double, Ends>> passedOver;
    bool found = false;
    while (!found && !this->longest.empty())
    {
      const std::pair<double, Ends> top = this->longest.top();
      this->longest.pop();
      const auto entry = this->trianglesOf.find(top.second);
      if (entry == this->trianglesOf.end() || entry->second.empty())
      {
        continue; // halved before
      }
      found = entry->second.size() <= mostTriangles;
      if (found)
      {
        this->split(top.second);
      }
      else
      {
        passedOver.push_back(top);
      }
    }
    for (const auto& edge : passedOver)
    {
      this->longest.push(edge);
    }
    return found;
  }

  vtkSmartPointer<vtkPolyData> getMesh() const
  {
    vtkNew<vtkPoints> meshPoints;
    for (const glm::dvec3& point : this->points)
    {
      meshPoints->InsertNextPoint(&point[0]);
    }
    vtkNew<vtkCellArray> cells;
    for (const std::array<Index, 3>& triangle : this->triangles)
    {
      cells->InsertNextCell({triangle[0], triangle[1], triangle[2]});
    }
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(meshPoints);
    mesh->SetPolys(cells);
    return mesh;
  }

private:
  static Ends endsOf(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

  void addTriangle(const std::array<Index, 3>& corners)
  {
    this->triangles.push_back(corners);
    this->addSides(this->triangles.size() - 1);
  }

  void addSides(std::size_t triangle)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Ends ends = endsOf(this->triangles[triangle][i], this->triangles[triangle][(i + 1) % 3]);
      std::vector<std::size_t>& neighbours = this->trianglesOf[ends];
      if (neighbours.empty())
      {
        this->longest.push({glm::distance(this->points[ends.first], this->points[ends.second]), ends});
      }
      neighbours.push_back(triangle);
    }
  }

  void removeSides(std::size_t triangle)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      std::vector<std::size_t>& neighbours =
          this->trianglesOf[endsOf(this->triangles[triangle][i], this->triangles[triangle][(i + 1) % 3])];
      neighbours.erase(std::remove(neighbours.begin(), neighbours.end(), triangle), neighbours.end());
    }
  }

  void split(const Ends& ends)
  {
    const auto middle = static_cast<Index>(this->points.size());
    this->points.push_back(0.5 * (this->points[ends.first] + this->points[ends.second]));
    for (const std::size_t triangle : std::vector<std::size_t>(this->trianglesOf[ends]))
    {
      this->removeSides(triangle);
      std::array<Index, 3> other = this->triangles[triangle];
      std::replace(this->triangles[triangle].begin(), this->triangles[triangle].end(), ends.first, middle);
      std::replace(other.begin(), other.end(), ends.second, middle);
      this->addSides(triangle);
      this->addTriangle(other);
    }
  }

  std::vector<glm::dvec3> points;
  std::vector<std::array<Index, 3>> triangles;
  std::map<Ends, std::vector<std::size_t>> trianglesOf;
  std::priority_queue<std::pair<double, Ends>> longest;
};

} // namespace

vtkSmartPointer<vtkPolyData> refineMesh(vtkPolyData* mesh, std::size_t triangles)
{
  Refiner refiner(mesh);
  while (refiner.countTriangles() < triangles)
  {
    const std::size_t left = triangles - refiner.countTriangles();
    if (!refiner.halve(left) && !refiner.halve(left + 1))
    {
      break;
    }
  }
  return refiner.getMesh();
}

} // namespace shadow::benchmarks
