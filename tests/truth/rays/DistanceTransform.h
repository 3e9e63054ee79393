#pragma once

#include <vector>

namespace shadow::truth
{

/// Distance in pixels from every pixel to the nearest one that is set; infinity where none is set.
///
/// @param set  width * height values, non-zero: set
/// @par Cost    O(pixels)
/// @par Source  Felzenszwalb & Huttenlocher 2012, "Distance Transforms of Sampled Functions"
std::vector<double> distanceTransform(const std::vector<unsigned char>& set, int width, int height);

} // namespace shadow::truth
