#pragma once

#include <string>
#include <vector>

class vtkRenderWindow;
class vtkShadowVolumePass;

namespace shadow::truth
{

/// All that can be seen of a rendering with shadows.
struct DrawnShadows
{
  int status = 0;
  std::string message;
  std::vector<long long> counts; ///< casters, and triangles and edges of volumes, of the renderer drawn last
  std::vector<std::vector<unsigned char>> masks; ///< a light that is switched on, of the renderer drawn last
  std::vector<unsigned char> picture;            ///< of the window, RGB
};

/// Renders a window and reads what a pass has drawn there.
DrawnShadows drawShadows(vtkRenderWindow* window, vtkShadowVolumePass* pass);

/// The same by a pass that has seen nothing before, with the settings of the other one, which keeps nothing.
/// @post  the renderers have the pass that they had
DrawnShadows drawByNewPass(vtkRenderWindow* window, vtkShadowVolumePass* pass);

/// In what two renderings differ, a line each; empty when they are the same to the bit.
std::string tellDifferences(const DrawnShadows& one, const DrawnShadows& other);

} // namespace shadow::truth
