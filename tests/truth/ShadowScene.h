#pragma once

#include <vtkActor.h>
#include <vtkHeadlessRenderWindow.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkShadowVolumePass.h>
#include <vtkSmartPointer.h>

#include "MaskError.h"
#include "MaskTruth.h"
#include "RayCaster.h"

class vtkAlgorithm;
class vtkMapper;

namespace shadow::truth
{

/// The true mask of one light of a scene as it stood when this was made, for as many comparisons as there are
/// ways to render it.
class SceneTruth
{
public:
  SceneTruth(const Scene& scene, const View& view, const Light& light)
      : caster(scene), truth(caster, view, light)
  {
  }
  SceneTruth(const SceneTruth&) = delete;
  SceneTruth& operator=(const SceneTruth&) = delete;

  const MaskTruth& mask() const { return this->truth; }

private:
  RayCaster caster;
  MaskTruth truth;
};

/// A scene in a headless window with the shadow pass attached, whose shadow masks can be held against the
/// truth.
class ShadowScene
{
public:
  ShadowScene(int width, int height);

  vtkActor* addSource(vtkAlgorithm* source); ///< an actor for a source's or reader's output
  vtkActor* addPolyData(vtkPolyData* polyData);
  vtkActor* addMapper(vtkMapper* mapper);

  /// A rectangle across the scene's visible props, just below their lowest point along y; larger than them by
  /// @p factor.
  vtkActor* addFloor(double factor = 3.0);

  vtkLight* addPointLight(double x, double y, double z);

  /// @param dx,dy,dz  the way the light travels
  vtkLight* addDirectionalLight(double dx, double dy, double dz);

  /// Looks at the centre of the visible props from the direction (dx, dy, dz), @p distance of their bounding
  /// box's diagonals away.
  void lookFrom(double dx, double dy, double dz, double distance = 1.6);

  /// Renders, and compares the mask of a light with the truth.
  ///
  /// @param light  index among the lights that are switched on
  /// @param full   whether the certain pixels are counted, too
  MaskError compare(int light = 0, bool full = false);

  /// The same with a truth that is known already. @pre @p truth is of the scene as it stands and of this
  /// light
  MaskError compare(const SceneTruth& truth, int light = 0, bool full = false);

  /// Casts the rays of a light's true mask. @pre the scene has been rendered since the camera or the window
  /// changed
  ///
  /// @param light  index among the lights that are switched on
  SceneTruth makeTruth(int light = 0);

  /// Renders, and reads the mask of a light. Bottom row first, 255 reached.
  std::vector<unsigned char> renderMask(int light = 0);

  /// Renders, and reads the picture. RGB, bottom row first.
  std::vector<unsigned char> renderPicture();

  vtkNew<vtkHeadlessRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkShadowVolumePass> pass;
};

} // namespace shadow::truth
