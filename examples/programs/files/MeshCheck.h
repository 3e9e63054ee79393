#ifndef shadow_examples_MeshCheck_h
#define shadow_examples_MeshCheck_h

#include <vtkSmartPointer.h>

#include <string>

class vtkDataSet;
class vtkPolyData;

namespace shadow::examples
{

/// Why a data set as a reader left it must not be handed to filters; empty when it may.
///
/// Readers do not check what they read: an index beyond the points makes the filters read foreign memory.
/// @par Cost  O(points + cells)
std::string findDamage(vtkDataSet* data);

/// The triangles of a data set's surface, with the coordinates it has: polygons and strips are cut up,
/// volumes give their outside. Point normals are kept, and made where there are none (points are then doubled
/// at sharp edges). Of all other arrays only 8-bit colours are kept, as the scalars.
///
/// @pre findDamage(data) is empty
/// @return without triangles when the data set has no surface
vtkSmartPointer<vtkPolyData> extractTriangles(vtkDataSet* data);

/// Whether at least one triangle has an area.
bool hasArea(vtkPolyData* triangles);

} // namespace shadow::examples

#endif
