#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include <vtkCommand.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>

#include "Pixels.h"
#include "ShadowScene.h"

class vtkRenderPass;
class vtkTexture;

namespace shadow::test
{

using truth::countDifferent;
using truth::Pixels;
using truth::readMask;
using truth::readPicture;

/// Certain pixels of a ball scene's mask that may be wrong: one on the ball's rim, where a triangle that is
/// seen from its edge is thinner than the rasteriser's grid.
inline constexpr std::size_t rimPixels = 1;

/// How vtkShadowVolumePass is attached to a renderer.
enum class Use
{
  Complete,     ///< SetPass(pass)
  Delegate,     ///< of a vtkCameraPass
  OpaqueOfSteps ///< opaque pass of a vtkRenderStepsPass
};
inline constexpr Use allUses[] = {Use::Complete, Use::Delegate, Use::OpaqueOfSteps};
const char* toString(Use use);

void attach(vtkRenderer* renderer, vtkRenderPass* pass, Use use);

/// VTK's own passes, without shadows.
void attachPlainSteps(vtkRenderer* renderer);

/// A ball over a table under a point light, in a small headless window. The ball shadows the table.
class BallScene : public truth::ShadowScene
{
public:
  explicit BallScene(int width = 200, int height = 150);

  /// The pixel in which a world point lies.
  std::array<int, 2> toPixel(const glm::dvec3& pointWC);

  /// Expects that many actors' backs to have been left out of the picture: none where the GL is no software,
  /// since the pass does not look for them there.
  void expectHiddenBacks(int onSoftware);

  int maskAt(const glm::dvec3& pointWC, int light = 0);   ///< renders
  double greyAt(const glm::dvec3& pointWC);               ///< renders; mean of red, green and blue
  std::array<int, 3> colourAt(const glm::dvec3& pointWC); ///< renders

  vtkNew<vtkSphereSource> ball; ///< radius 0.5 around (0, 1, 0)
  vtkActor* ballActor;
  vtkActor* table; ///< y = 0
  vtkLight* lamp;

  /// Points of the table.
  static inline const glm::dvec3 inShadow{0.5, 0.0, 0.0};
  static inline const glm::dvec3 lit{-1.2, 0.0, 0.8};
};

/// Without alpha but for one texel in a corner, so that VTK takes what has it for opaque.
vtkSmartPointer<vtkTexture> makeTextureOfHoles();

std::size_t countValue(const Pixels& pixels, int value);

/// Counts an object's vtkErrorMacro and vtkWarningMacro, and keeps them off the output window.
class MessageCounter : public vtkCommand
{
public:
  static vtkSmartPointer<MessageCounter> observe(vtkObject* object);
  void Execute(vtkObject* caller, unsigned long event, void* data) override;

  int errors = 0;
  int warnings = 0;
  std::string last;

protected:
  MessageCounter() = default;
};

} // namespace shadow::test
