#ifndef MeshImport_h
#define MeshImport_h

#include "SEDGeometry.h"

class vtkPolyData;

namespace shadow
{

/// The triangles of a data set as VTK's mappers draw them: polygons as fans around their first corner, strips
/// with alternating winding; vertices and lines are left out. Cost: O(points + cells).
TriangleSoup importTriangles(vtkPolyData* polyData);

} // namespace shadow

#endif
