#ifndef shadow_examples_SceneSetup_h
#define shadow_examples_SceneSetup_h

#include "ModelReader.h"

#include <vtkBoundingBox.h>

#include <vector>

class vtkRenderer;

namespace shadow::examples
{

/// The models as they are, each in its file's colour or one of a few of ours.
///
/// @return what they take up, in world space
vtkBoundingBox addModels(vtkRenderer* renderer, const std::vector<Model>& models);

/// A handful of solids that stand on y = 0, for a program that is given no model.
///
/// @return what they take up, in world space
vtkBoundingBox addBuiltInScene(vtkRenderer* renderer);

/// A square in the x-z plane, a hair below `models` (touching surfaces would take turns at being in front)
/// and several times as large.
///
/// @return what it takes up, in world space
vtkBoundingBox addFloor(vtkRenderer* renderer, const vtkBoundingBox& models);

/// Points of all that a renderer shows, in world space; of a large scene about every n-th, so that there are
/// some thousand.
std::vector<Vector3> samplePoints(vtkRenderer* renderer);

/// A quiet backdrop, darker below.
void setBackground(vtkRenderer* renderer);

} // namespace shadow::examples

#endif
