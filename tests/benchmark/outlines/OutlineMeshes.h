#pragma once

#include <string>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

class vtkAlgorithm;

namespace shadow::benchmarks
{

/// Triangles that share points, as every way of drawing outlines needs them.
using Mesh = vtkSmartPointer<vtkPolyData>;

/// The triangles of a source, points at one place made one.
Mesh clean(vtkAlgorithm* source);

/// Twelve rings beside and behind one another, 30,000 triangles.
Mesh makeRings();

/// One of the shared meshes; nothing, and a line that says so, when it is not there.
Mesh readModel(const std::string& name);

} // namespace shadow::benchmarks
