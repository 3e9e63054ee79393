#pragma once

#include <string>
#include <utility>
#include <vector>

namespace shadow::benchmarks
{

/// What a frame costs against one number of a scene.
struct CostGrowth
{
  std::string against;                            ///< triangles, instances, lights
  std::vector<std::pair<double, double>> frames;  ///< number, milliseconds of the pass's frame; a light moves
  std::vector<std::pair<double, double>> shadows; ///< of these, beyond plain VTK's
};

/// Triangles of one torus, actors of one sphere, lights over a torus; all savings on.
/// @param scale  of the numbers, 1: up to 1,000,000 triangles, 2,000 actors, 32 lights
std::vector<CostGrowth> measureGrowth(double scale, int width, int height, int rounds);

/// Draws all as lines on logarithmic axes into an SVG file.
/// @throws std::runtime_error when the file cannot be written, or this build has no charts
void plotGrowth(const std::vector<CostGrowth>& growths, const std::string& file);

} // namespace shadow::benchmarks
