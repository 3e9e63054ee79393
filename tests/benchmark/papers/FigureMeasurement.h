#pragma once

#include <string>
#include <vector>

#include <vtkType.h>

#include "FigureScene.h"

namespace shadow::benchmarks
{

/// A row of a figure.
struct FigureMethod
{
  static constexpr int withoutShadows = -1;

  std::string name;
  int silhouette = withoutShadows; ///< vtkShadowVolumePass::SilhouetteMethods
};

/// no-shadows, brute-force, and every other silhouette method of vtkShadowVolumePass that can be told apart
/// from these. Auto stands for one of the others and is none of them.
std::vector<FigureMethod> allFigureMethods();

/// How a figure is measured.
struct FigureEffort
{
  int rounds = 7; ///< in each of which every method has one turn
  int frames = 3; ///< timed, of each turn
};

/// What one method took at one point of a figure. Medians over all frames.
struct FigureSample
{
  double milliseconds = 0.0; ///< of a frame, the light moved and everything rebuilt

  // Of frames that wait for the GL after each stage, which makes them a little slower.
  double scene = 0.0;
  double silhouette = 0.0; ///< with reading back
  double readBack = 0.0;
  double prePass = 0.0;
  double stencil = 0.0;
  double lighting = 0.0;

  // Of the last frame.
  vtkIdType sceneTriangles = 0;
  vtkIdType sideTriangles = 0;
  vtkIdType drawnTriangles = 0;
  std::string message; ///< why something was not drawn as asked; else empty
};

/// Draws a scene by each method in turns.
///
/// @param stencilMethod  of vtkShadowVolumePass
/// @return a sample for each method
/// @throws std::runtime_error when the GL cannot draw shadow volumes at all
std::vector<FigureSample> measureFigurePoint(FigureScene& scene, const std::vector<FigureMethod>& methods,
                                             int stencilMethod, const FigureEffort& effort);

} // namespace shadow::benchmarks
