#ifndef shadow_examples_ModelReader_h
#define shadow_examples_ModelReader_h

#include "OptionValues.h"

#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <vector>

class vtkPolyData;

namespace shadow::examples
{

/// Triangles with normals that are drawn with one colour.
struct ModelPart
{
  vtkSmartPointer<vtkPolyData> surface;
  std::optional<Vector3> colour; ///< the file's own, red green blue in [0, 1]
  double opacity = 1.0;          ///< below 1 it is translucent, and casts no shadow
};

/// What a mesh file holds, in the file's own coordinates.
struct Model
{
  std::string file;
  std::vector<ModelPart> parts; ///< one; for glTF one for each primitive
  vtkIdType triangles = 0;      ///< of all parts
};

/// Reads obj, ply, stl, vtp, vtk (legacy; of a volume grid its outside), gltf or glb, told apart by the
/// name's ending.
///
/// @param program  its name, for the line that it ends with when a reader crashes on a damaged file (see
/// ReaderGuard)
/// @param warnings  what the reader had to say about a file that is good all the same, one line each, is
/// added here
/// @post  every coordinate is finite and at least one triangle has an area
/// @throws UserError  one line that begins with the file's name
Model readModel(const std::string& file, const std::string& program, std::vector<std::string>& warnings);

} // namespace shadow::examples

#endif
