#pragma once

#include <string>

namespace shadow::benchmarks
{

/// Registers CoplanarTolerance/MODEL/DEGREES for the models that are found in a folder: what HSD's tolerance
/// does to the picture, as wrong certain pixels per million against ray-cast truth, over lights all around.
void registerCoplanarTolerance(const std::string& modelFolder);

} // namespace shadow::benchmarks
