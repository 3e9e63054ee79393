#pragma once

#include <string>

#include "FuzzSession.h"

namespace shadow::fuzz
{

/// Writes @p base-truth.png, and for each mask a picture of the mask and one of its differences: black and white where it is
/// right, red where a certain pixel is wrong, yellow where another one is.
void writePictures(const DrawnScene& drawn, const std::string& base);

} // namespace shadow::fuzz
