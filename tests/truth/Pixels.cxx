#include "Pixels.h"

#include <algorithm>
#include <cstdlib>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkShadowVolumePass.h>
#include <vtkUnsignedCharArray.h>

namespace shadow::truth
{

Pixels readMask(vtkShadowVolumePass* pass, int light)
{
  vtkNew<vtkImageData> image;
  if (!pass->GetShadowMask(light, image))
  {
    return {};
  }
  const auto* pixels = static_cast<const unsigned char*>(image->GetScalarPointer());
  return {pixels, pixels + image->GetNumberOfPoints()};
}

Pixels readPicture(vtkRenderWindow* window)
{
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels.GetPointer(), 0);
  return {pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues()};
}

std::size_t countDifferent(const Pixels& a, const Pixels& b, int tolerance)
{
  if (a.size() != b.size())
  {
    return std::max(a.size(), b.size());
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    count += std::abs(a[i] - b[i]) > tolerance ? 1 : 0;
  }
  return count;
}

} // namespace shadow::truth
