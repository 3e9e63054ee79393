#pragma once

#include <string>

#include "FuzzSession.h"

namespace shadow::fuzz
{

/// Writes the truth, and each mask with its differences: black and white where it is right, red where a
/// certain pixel is wrong, yellow where another one is.
///
/// @param base  what the names of all files begin with; base-truth.png is the truth
void writePictures(const DrawnScene& drawn, const std::string& base);

} // namespace shadow::fuzz
