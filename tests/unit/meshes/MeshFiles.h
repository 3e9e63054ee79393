#pragma once

#include <string>
#include <vector>

#include "SEDGeometry.h"

namespace shadow::test
{

/// The mesh files of a folder, sorted; none is fine.
std::vector<std::string> findMeshFiles(const std::string& folder);

/// Vertices and faces of a Wavefront OBJ file; a face is a fan around its first corner.
///
/// @throws std::runtime_error when there is none
TriangleSoup readMeshFile(const std::string& file);

/// The file's name as one of a test: letters and digits.
std::string toTestName(const std::string& file);

} // namespace shadow::test
