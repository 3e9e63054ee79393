#ifndef shadow_examples_Camera_h
#define shadow_examples_Camera_h

#include "OptionValues.h"

#include <optional>
#include <vector>

class vtkRenderer;

namespace shadow::examples
{

/// What a chosen camera shall have in view.
struct CameraSubject
{
  std::vector<Vector3> points;       ///< of the models; some thousand tell their shape well enough
  std::vector<LightOption> lights;   ///< the shadows they throw on the floor shall be in view, too
  std::optional<double> floorHeight; ///< y; none: no floor
  double aspect = 1.0;               ///< width / height of the picture
};

/// A three-quarter view from above that the subject fills.
///
/// @pre  subject.points is not empty
/// @par Cost  O(points * lights)
CameraOption chooseCamera(const CameraSubject& subject);

/// @param parallelScale  half the height of the view in world units; none: perspective
/// @post  the clipping range holds everything that the renderer shows
void setCamera(vtkRenderer* renderer, const CameraOption& camera, const std::optional<double>& parallelScale);

} // namespace shadow::examples

#endif
