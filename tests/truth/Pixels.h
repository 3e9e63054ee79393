#pragma once

#include <cstddef>
#include <vector>

class vtkRenderWindow;
class vtkShadowVolumePass;

namespace shadow::truth
{

/// Bytes of a mask or a picture, bottom row first.
using Pixels = std::vector<unsigned char>;

/// The shadow mask of a light as it was drawn last, 255 reached. Empty where there is none.
/// @param light  index among the lights that are switched on
Pixels readMask(vtkShadowVolumePass* pass, int light);

/// The picture in a window's back buffer, RGB.
Pixels readPicture(vtkRenderWindow* window);

/// How many values differ by more than @p tolerance. All of them when the sizes differ.
std::size_t countDifferent(const Pixels& a, const Pixels& b, int tolerance = 0);

} // namespace shadow::truth
