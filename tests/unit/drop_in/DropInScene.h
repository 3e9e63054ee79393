#pragma once

#include <array>
#include <functional>
#include <vector>

#include <vtkObject.h>
#include <vtkSmartPointer.h>

#include "BallScene.h"

class vtkImageData;
class vtkPropCollection;
class vtkVolumeMapper;

namespace shadow::test
{

/// The scene that a row of the table fills: a ball over a table under a lamp, in a small headless window.
struct DropInScene : BallScene
{
  DropInScene();

  std::vector<vtkRenderer*> passed{this->renderer}; ///< the renderers that get the pass
  std::vector<vtkSmartPointer<vtkObject>> kept;     ///< what nobody else keeps
  std::function<void()> render;                     ///< draws one picture; the window's Render() if empty
  Pixels tiled;                                     ///< what else a row shows, RGBA; compared as well
  vtkSmartPointer<vtkPropCollection> pickFrom;      ///< what may be picked, if not all
};

/// A box that stands on the table.
vtkActor* addBox(DropInScene& scene, double x, double z, double size = 0.5);

/// A ball of radius 0.4 of coloured glass.
vtkActor* addGlass(DropInScene& scene, const std::array<double, 3>& colour,
                   const std::array<double, 3>& centre);

/// A picture of smooth colours, so that texture filtering has something to do.
vtkSmartPointer<vtkTexture> makeTexture(int components = 3);

/// A cube of bytes, largest in its middle.
vtkSmartPointer<vtkImageData> makeGrid(int size = 16);

/// A cloud beside the ball.
void addVolume(DropInScene& scene, vtkVolumeMapper* mapper, bool shaded);

} // namespace shadow::test
