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

/// Appends the surface triangles that an updated mapper draws, in world space and double precision. Each of
/// its data sets becomes a part of its own.
///
/// Polygons are fans around their first corner, as VTK's mappers draw them; where a polygon is not flat, this
/// decides what its surface is. Covers vtkPolyDataMapper, vtkDataSetMapper and the composite mappers with
/// hidden blocks left out; the mapper's clipping planes are applied.
///
/// @param style  its flags are given to every triangle
/// @throws std::invalid_argument  for a mapper that draws something else than its input's surface
void appendWorldTriangles(vtkMapper* mapper, const glm::dmat4& worldFromMC, const Triangle& style,
                          Scene& scene);

} // namespace shadow::truth
