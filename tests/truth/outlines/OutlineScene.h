#pragma once

#include <string>
#include <vector>

#include <vtkSilhouettePass.h>

#include "OutlineError.h"
#include "OutlineTruth.h"
#include "ShadowScene.h"

namespace shadow::truth
{

/// A scene in a headless window drawn by the outline pass, whose lines can be held against the truth.
class OutlineScene : public ShadowScene
{
public:
  OutlineScene(int width, int height);

  /// The true outline of the scene as it stands. @pre the scene has been rendered since the camera or the
  /// window changed
  OutlineTruth makeOutline(const OutlineOptions& options = {});

  /// Renders lines of a width in pixels, and reads their mask. Bottom row first, 255 line.
  std::vector<unsigned char> renderLines(double lineWidth);

  vtkNew<vtkSilhouettePass> outlines;
};

/// The widths that lines are judged at, in pixels.
inline const std::vector<double>& judgedWidths()
{
  static const std::vector<double> widths = {1.0, 2.0, 4.0, 8.0};
  return widths;
}

/// The least share of certain line pixels that have to be drawn, and of drawn pixels that have to be where
/// a line may be.
constexpr double leastRightLines = 0.999;

/// Renders at every judged width, and expects the lines to be true and without spikes. The figures are
/// printed, with the pixels that are wrong, and recorded as properties of the test.
///
/// @param what  tells this rendering from others in the test
void expectTrueLines(OutlineScene& scene, const OutlineTruth& truth, const std::string& what = "");

} // namespace shadow::truth
