#ifndef shadow_examples_GltfMaterial_h
#define shadow_examples_GltfMaterial_h

#include <optional>

#include "RenderOptions.h"

class vtkDataSet;

namespace shadow::examples
{

/// What can be shown of the material of a glTF primitive without its textures.
struct GltfMaterial
{
  std::optional<Vector3> colour; ///< red green blue in [0, 1]
  double opacity = 1.0;          ///< below 1 for alphaMode BLEND only
  bool isSeen = true;            ///< false: alphaMode MASK, and its alpha is below the cutoff
};

/// Reads what vtkGLTFReader says of a primitive, and turns its vertex colours into scalars that VTK draws as they
/// are: times the material's colour, with alpha where the material blends.
/// @par Source  Khronos, glTF 2.0 specification, 3.9.2 and 3.9.4
GltfMaterial readGltfMaterial(vtkDataSet* primitive);

} // namespace shadow::examples

#endif
