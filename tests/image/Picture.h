#pragma once

#include <string>

#include <vtkSmartPointer.h>

class vtkImageData;
class vtkRenderWindow;

namespace shadow::test
{

/// Renders a window, and reads its picture: 8-bit RGB.
vtkSmartPointer<vtkImageData> takePicture(vtkRenderWindow* window);

/// Reads a PNG file. Nothing when there is none that can be read.
vtkSmartPointer<vtkImageData> readPicture(const std::string& fileName);

/// @throws std::runtime_error  when the file cannot be written
void writePicture(vtkImageData* picture, const std::string& fileName);

/// How two pictures differ.
struct PictureDifference
{
  /// Share of the pixels, in per cent, that are unlike every one of the nine pixels around the same place in
  /// the other picture; 100 when the sizes differ. An edge that moved by a pixel does not count, a shadow
  /// that is lost does.
  double percent = 100.0;
  bool identical = false;
  vtkSmartPointer<vtkImageData> image; ///< 8-bit grey: how much a pixel differs; none when the sizes differ
};

/// @param tolerance  grey levels in any channel up to which pixels are alike
PictureDifference comparePictures(vtkImageData* a, vtkImageData* b, int tolerance = 12);

} // namespace shadow::test
