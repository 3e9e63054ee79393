#ifndef shadow_examples_TextCheck_h
#define shadow_examples_TextCheck_h

#include <string>

#include "ObjCopy.h"

namespace shadow::examples
{

// vtkOBJReader takes what is no number for 0, and uses indices of texture coordinates and normals unseen. So its
// files are looked through first.

/// What is wrong with an OBJ file, and what its reader has to be helped with.
///
/// Looks at points and faces: three finite coordinates, and indices of points, texture coordinates and
/// normals that are there.
/// @par Cost  reads the file once
ObjFindings checkObj(const std::string& file);

} // namespace shadow::examples

#endif
