#pragma once

#include <functional>
#include <string>
#include <vector>

#include <vtkAlgorithm.h>
#include <vtkSmartPointer.h>

namespace shadow::benchmarks
{

/// Registers `Kept/MODEL/...` for each model, and for a thousand actors: four lights, and nothing moves (`still`),
/// the camera does (`camera`), or one of the lights (`light`). Plain VTK, a pass that makes everything anew and
/// one that keeps what it can, in turns.
void registerKeptFrames(const std::vector<std::string>& models,
                        const std::function<vtkSmartPointer<vtkAlgorithm>(const std::string&)>& makeSource);

} // namespace shadow::benchmarks
