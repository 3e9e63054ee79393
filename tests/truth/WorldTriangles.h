#pragma once

#include <glm/glm.hpp>

#include "TruthScene.h"

class vtkDataObject;
class vtkMapper;
class vtkMatrix4x4;

namespace shadow::truth
{

/// The matrix as GLM keeps it; both multiply column vectors from the left.
glm::dmat4 toGlm(vtkMatrix4x4* matrix);

/// Appends the surface triangles that an updated mapper draws, in world space and double precision.
///
/// Polygons and strips go through vtkTriangleFilter, so that whoever else triangulates with it sees the same
/// triangles. Covers vtkPolyDataMapper, vtkDataSetMapper and the composite mappers with hidden blocks left
/// out; the mapper's clipping planes are applied.
///
/// @param style  its flags are given to every triangle
/// @throws std::invalid_argument  for a mapper that draws something else than its input's surface
void appendWorldTriangles(vtkMapper* mapper, const glm::dmat4& worldFromMC, const Triangle& style,
                          Scene& scene);

} // namespace shadow::truth
