#include "PictureScale.h"

#include <cmath>

#include <vtkCamera.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLRenderer.h>

namespace shadow
{

double PictureScale::update(vtkOpenGLRenderer* renderer, vtkOpenGLRenderWindow* window)
{
  const int* scale = window->GetTileScale();
  if (scale[0] > 1 || scale[1] > 1)
  {
    this->tiles = 1;
    return 0.5 * (scale[0] + scale[1]);
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  const double* centre = camera->GetWindowCenter();
  // Tile i of n is at 2 i + 1 - n.
  const bool isFirst = centre[0] == centre[1] && centre[0] <= -1.0 && centre[0] == std::floor(centre[0]);
  if (isFirst)
  {
    this->tiles = static_cast<int>(1.0 - centre[0]);
    this->viewAngle = camera->GetViewAngle();
    this->viewHeight = camera->GetParallelScale();
  }
  const auto isTile = [this](double place)
  {
    const double index = 0.5 * (place + this->tiles - 1.0);
    return index == std::floor(index) && index >= 0.0 && index < this->tiles;
  };
  if (!isTile(centre[0]) || !isTile(centre[1]) || camera->GetViewAngle() != this->viewAngle ||
      camera->GetParallelScale() != this->viewHeight)
  {
    this->tiles = 1;
  }
  return this->tiles;
}

} // namespace shadow
