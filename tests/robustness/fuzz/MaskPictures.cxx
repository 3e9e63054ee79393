#include "MaskPictures.h"

#include <algorithm>
#include <array>

#include <vtkImageData.h>
#include <vtkPNGWriter.h>

namespace shadow::fuzz
{

namespace
{

void writePng(const std::vector<unsigned char>& values, int components, const CertainPixels& truth,
              const std::string& fileName)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(truth.getWidth(), truth.getHeight(), 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  std::copy(values.begin(), values.end(), static_cast<unsigned char*>(image->GetScalarPointer()));
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(fileName.c_str());
  writer->SetInputData(image);
  writer->Write();
}

std::vector<unsigned char> makeDifference(const CertainPixels& truth, const std::vector<unsigned char>& mask)
{
  std::vector<unsigned char> colours;
  for (int y = 0; y < truth.getHeight(); ++y)
  {
    for (int x = 0; x < truth.getWidth(); ++x)
    {
      const std::size_t pixel = static_cast<std::size_t>(y) * truth.getWidth() + x;
      const unsigned char value = truth.getMask()[pixel];
      std::array<unsigned char, 3> colour = {value, value, value};
      if ((value >= 128) != (mask[pixel] >= 128))
      {
        colour = {255, static_cast<unsigned char>(truth.isCertain(x, y) ? 0 : 255), 0};
      }
      colours.insert(colours.end(), colour.begin(), colour.end());
    }
  }
  return colours;
}

} // namespace

void writePictures(const DrawnScene& drawn, const std::string& base)
{
  writePng(drawn.truth->getMask(), 1, *drawn.truth, base + "-truth.png");
  for (const DrawnMask& mask : drawn.masks)
  {
    std::string name = base + "-" + getName(mask.config);
    std::replace(name.begin(), name.end(), ' ', '-');
    writePng(mask.mask, 1, *drawn.truth, name + ".png");
    writePng(makeDifference(*drawn.truth, mask.mask), 3, *drawn.truth, name + "-difference.png");
  }
}

} // namespace shadow::fuzz
