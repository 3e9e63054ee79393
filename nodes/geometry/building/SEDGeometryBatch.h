#pragma once

#include <optional>
#include <string>
#include <vector>

#include "SEDGeometry.h"

namespace shadow
{

/// One call of buildSEDGeometry(): what goes in, and what comes out.
struct SEDGeometryJob
{
  TriangleSoup soup; ///< empty afterwards
  SEDGeometryOptions options;
  std::optional<SEDGeometry> geometry; ///< none when the soup cannot be used
  std::string error;                   ///< then one line that says why
};

/// Builds meshes as buildSEDGeometry() does, each, but several at once: small ones beside each other, a large one by
/// all threads together. What comes out does not depend on how many threads there are, but for the numbers of
/// SEDGeometry::getTopology() and getRasterOrder(), which differ from mesh to mesh as ever.
///
/// @pre  no job's previous mesh is built by another job
void buildSEDGeometries(std::vector<SEDGeometryJob>& jobs, const ParallelFor& parallelFor);

} // namespace shadow
