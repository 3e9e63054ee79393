#include "Picture.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

namespace shadow::test
{

namespace
{

const unsigned char* pixelAt(vtkImageData* image, int x, int y)
{
  return static_cast<const unsigned char*>(image->GetScalarPointer(x, y, 0));
}

int channelDifference(const unsigned char* a, const unsigned char* b)
{
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

/// How much a pixel differs from the one around the same place that is most like it.
int difference(vtkImageData* from, vtkImageData* to, int x, int y, const int* size)
{
  int least = std::numeric_limits<int>::max();
  for (int j = std::max(0, y - 1); j <= std::min(size[1] - 1, y + 1); ++j)
  {
    for (int i = std::max(0, x - 1); i <= std::min(size[0] - 1, x + 1); ++i)
    {
      least = std::min(least, channelDifference(pixelAt(from, x, y), pixelAt(to, i, j)));
    }
  }
  return least;
}

} // namespace

vtkSmartPointer<vtkImageData> takePicture(vtkRenderWindow* window)
{
  window->Render();
  const int* size = window->GetSize();
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(size[0], size[1], 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels, 0);
  std::copy_n(pixels->GetPointer(0), pixels->GetNumberOfValues(),
              static_cast<unsigned char*>(picture->GetScalarPointer()));
  return picture;
}

vtkSmartPointer<vtkImageData> readPicture(const std::string& fileName)
{
  vtkNew<vtkPNGReader> reader;
  if (reader->CanReadFile(fileName.c_str()) == 0)
  {
    return nullptr;
  }
  reader->SetFileName(fileName.c_str());
  reader->Update();
  return reader->GetOutput();
}

void writePicture(vtkImageData* picture, const std::string& fileName)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->SetFileName(fileName.c_str());
  writer->SetCompressionLevel(9);
  writer->Write();
  if (writer->GetErrorCode() != 0)
  {
    throw std::runtime_error("cannot write " + fileName);
  }
}

PictureDifference comparePictures(vtkImageData* a, vtkImageData* b, int tolerance)
{
  PictureDifference result;
  const int* size = a->GetDimensions();
  if (!std::equal(size, size + 3, b->GetDimensions()) || a->GetNumberOfScalarComponents() != 3 ||
      b->GetNumberOfScalarComponents() != 3)
  {
    return result;
  }
  result.image = vtkSmartPointer<vtkImageData>::New();
  result.image->SetDimensions(size[0], size[1], 1);
  result.image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  result.identical = true;
  int unlike = 0;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      result.identical = result.identical && channelDifference(pixelAt(a, x, y), pixelAt(b, x, y)) == 0;
      const int most = std::max(difference(a, b, x, y, size), difference(b, a, x, y, size));
      unlike += most > tolerance ? 1 : 0;
      *static_cast<unsigned char*>(result.image->GetScalarPointer(x, y, 0)) =
          static_cast<unsigned char>(most);
    }
  }
  result.percent = 100.0 * unlike / (static_cast<double>(size[0]) * size[1]);
  return result;
}

} // namespace shadow::test
