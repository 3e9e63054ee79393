#include "PaperObjects.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include <vtkCleanPolyData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPolyData.h>
#include <vtkQuadricDecimation.h>

#include "TestMeshes.h"

namespace shadow::benchmarks
{

namespace
{

constexpr double pi = 3.14159265358979323846;

TriangleSoup makeIcosahedron()
{
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  TriangleSoup soup;
  soup.points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                 {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  soup.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  return soup;
}

/// Squares of two triangles each in a plane that stands on the floor, so that it casts.
TriangleSoup makePlane(std::uint32_t columns, std::uint32_t rows)
{
  TriangleSoup soup;
  for (std::uint32_t row = 0; row <= rows; ++row)
  {
    for (std::uint32_t column = 0; column <= columns; ++column)
    {
      soup.points.emplace_back(column, row, 0.0);
    }
  }
  for (std::uint32_t row = 0; row < rows; ++row)
  {
    for (std::uint32_t column = 0; column < columns; ++column)
    {
      const std::uint32_t a = row * (columns + 1) + column;
      const std::uint32_t above = a + columns + 1;
      soup.triangles.push_back({a, a + 1, above + 1});
      soup.triangles.push_back({a, above + 1, above});
    }
  }
  return soup;
}

TriangleSoup toSoup(vtkPolyData* polyData)
{
  TriangleSoup soup;
  for (vtkIdType point = 0; point < polyData->GetNumberOfPoints(); ++point)
  {
    double p[3];
    polyData->GetPoint(point, p);
    soup.points.emplace_back(p[0], p[1], p[2]);
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < polyData->GetNumberOfCells(); ++cell)
  {
    polyData->GetCellPoints(cell, corners);
    if (corners->GetNumberOfIds() == 3)
    {
      soup.triangles.push_back({static_cast<std::uint32_t>(corners->GetId(0)),
                                static_cast<std::uint32_t>(corners->GetId(1)),
                                static_cast<std::uint32_t>(corners->GetId(2))});
    }
  }
  return soup;
}

/// The mesh with the number of edges nearest to the wanted one that decimation finds on its way.
TriangleSoup coarsen(const std::string& file, std::size_t wantedEdges)
{
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(file.c_str());
  vtkNew<vtkCleanPolyData> welded;
  welded->SetInputConnection(reader->GetOutputPort());
  welded->Update();
  const auto triangles = static_cast<double>(welded->GetOutput()->GetNumberOfPolys());
  vtkNew<vtkQuadricDecimation> decimation;
  decimation->SetInputConnection(welded->GetOutputPort());
  TriangleSoup best;
  std::size_t bestOff = wantedEdges;
  // A closed mesh has 1.5 edges a triangle; how many more an open one has depends on its borders.
  double wantedTriangles = static_cast<double>(wantedEdges) / 1.5;
  for (int round = 0; round < 6 && bestOff > 0; ++round)
  {
    decimation->SetTargetReduction(1.0 - wantedTriangles / triangles);
    decimation->Update();
    TriangleSoup soup = toSoup(decimation->GetOutput());
    const auto off = static_cast<std::ptrdiff_t>(test::build(soup).getEdges().size()) -
                     static_cast<std::ptrdiff_t>(wantedEdges);
    if (static_cast<std::size_t>(std::abs(off)) < bestOff)
    {
      bestOff = static_cast<std::size_t>(std::abs(off));
      best = std::move(soup);
    }
    wantedTriangles -= static_cast<double>(off) / 1.5;
  }
  return best;
}

} // namespace

TriangleSoup makePrism(std::uint32_t faces, std::uint32_t meanSides)
{
  const std::uint32_t columns = faces - 2;
  const std::uint32_t points = faces * meanSides / 2 - 3 * columns; // on the upright edges
  TriangleSoup soup;
  std::vector<std::vector<std::uint32_t>> uprights(columns); // vertices from the bottom to the top
  for (std::uint32_t column = 0; column < columns; ++column)
  {
    // In single precision, so that the points of an upright edge stand exactly above each other.
    const double angle = 2.0 * pi * column / columns;
    const auto x = static_cast<float>(std::cos(angle));
    const auto y = static_cast<float>(std::sin(angle));
    const std::uint32_t steps = 1 + points / columns + (column < points % columns ? 1 : 0);
    for (std::uint32_t step = 0; step <= steps; ++step)
    {
      uprights[column].push_back(static_cast<std::uint32_t>(soup.points.size()));
      soup.points.emplace_back(x, y, 2.0 * step / steps - 1.0);
    }
  }
  for (std::uint32_t column = 0; column < columns; ++column)
  {
    // A zigzag from one upright edge to the next: a fan would have triangles without area.
    const std::vector<std::uint32_t>& left = uprights[column];
    const std::vector<std::uint32_t>& right = uprights[(column + 1) % columns];
    for (std::size_t i = 0, j = 0; i + 1 < left.size() || j + 1 < right.size();)
    {
      if (j + 1 < right.size() && (j <= i || i + 1 == left.size()))
      {
        soup.triangles.push_back({left[i], right[j], right[j + 1]});
        ++j;
      }
      else
      {
        soup.triangles.push_back({left[i], right[j], left[i + 1]});
        ++i;
      }
    }
    if (column > 0 && column + 1 < columns)
    {
      soup.triangles.push_back({uprights[0].back(), left.back(), right.back()});
      soup.triangles.push_back({uprights[0].front(), right.front(), left.front()});
    }
  }
  return soup;
}

std::vector<PaperObject> makePaperObjects(const std::string& bunnyFile)
{
  std::vector<PaperObject> objects = {
      {"cube", test::makeCube(), 12}, {"sphere", makeIcosahedron(), 30}, {"plane", makePlane(14, 2), 100}};
  if (std::filesystem::exists(bunnyFile))
  {
    objects.push_back({"bunny", coarsen(bunnyFile, 2207), 2207});
  }
  return objects;
}

} // namespace shadow::benchmarks
