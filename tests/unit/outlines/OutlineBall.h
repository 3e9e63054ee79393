#pragma once

#include <vtkImageData.h>
#include <vtkSilhouettePass.h>

#include "BallScene.h"

namespace shadow::test
{

/// The line mask of a pass's last rendering; empty when it has none.
inline Pixels readLines(vtkSilhouettePass* pass)
{
  vtkNew<vtkImageData> image;
  if (!pass->GetLineMask(image))
  {
    return {};
  }
  const auto* pixels = static_cast<const unsigned char*>(image->GetScalarPointer());
  return {pixels, pixels + image->GetNumberOfPoints()};
}

/// A ball over a table in a small headless window, with outlines in place of shadows.
class OutlineBall : public BallScene
{
public:
  explicit OutlineBall(int width = 200, int height = 150) : BallScene(width, height)
  {
    this->renderer->SetPass(this->outlines);
  }

  /// Renders.
  Pixels renderLines()
  {
    this->window->Render();
    return readLines(this->outlines);
  }

  vtkNew<vtkSilhouettePass> outlines;
};

/// Lines of the ball and the table that are certainly there, in pixels.
inline constexpr std::size_t fewestLinePixels = 500;

} // namespace shadow::test
