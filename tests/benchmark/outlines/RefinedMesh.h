#pragma once

#include <cstddef>

#include <vtkSmartPointer.h>

class vtkPolyData;

namespace shadow::benchmarks
{

/// The same surface in more triangles: the longest edges are halved, one after the other.
///
/// @param mesh       triangles that share points
/// @param triangles  at least the mesh's; reached exactly unless only inner edges are left, then up to one
/// more
/// @par Cost  O(n log n)
vtkSmartPointer<vtkPolyData> refineMesh(vtkPolyData* mesh, std::size_t triangles);

} // namespace shadow::benchmarks
