#pragma once

#include <cstdint>
#include <vector>

#include "FlatRegions.h"

namespace shadow::test
{

std::vector<std::uint32_t> trianglesOf(const FlatRegions& regions, const FlatPolygon& polygon);

/// Expects what holds for the regions of any mesh, with any tolerance.
void expectSound(const SEDGeometry& geometry, const FlatRegions& regions);

} // namespace shadow::test
