#ifndef shadow_examples_PlyFile_h
#define shadow_examples_PlyFile_h

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkPolyData;

namespace shadow::examples
{

/// Reads a PLY file, text or binary: points with normals and colours, faces with colours, triangle strips. What
/// else it holds is passed over.
///
/// vtkPLYReader is not used: it rounds to single precision, and writes and frees foreign memory where a list has
/// no room or the file ends early. Points are in double precision here where single precision would be seen.
///
/// @param[out] warnings  of points that the file itself has rounded to visible steps
/// @throws UserError with the place of the first fault; nothing is allocated that the file is too short for
/// @par Cost  reads the file once
vtkSmartPointer<vtkPolyData> readPlyFile(const std::string& file, std::vector<std::string>& warnings);

} // namespace shadow::examples

#endif
