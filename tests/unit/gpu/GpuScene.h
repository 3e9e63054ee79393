#pragma once

#include <memory>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include <vtkHeadlessRenderWindow.h>
#include <vtkNew.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>

#include "SEDGeode.h"
#include "SilhouetteCamera.h"
#include "TestMeshes.h"
#include "TriangleDrawable.h"
#include "VETCollector.h"

namespace shadow::test
{

/// A headless window whose context is current, with nothing in it.
class GpuWindow
{
public:
  GpuWindow();
  ~GpuWindow();
  GpuWindow(const GpuWindow&) = delete;
  GpuWindow& operator=(const GpuWindow&) = delete;

  vtkOpenGLState* getState();
  operator vtkHeadlessRenderWindow*() { return this->window; }

private:
  vtkNew<vtkHeadlessRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
};

/// A scene graph and what decides its triangles' facing on the GPU.
class GpuScene
{
public:
  explicit GpuScene(int maximumSide = 0) : camera(maximumSide) {}
  ~GpuScene();
  GpuScene(const GpuScene&) = delete;
  GpuScene& operator=(const GpuScene&) = delete;

  /// Adds a geode under a transform. @return the transform
  std::shared_ptr<Transform> add(const std::shared_ptr<const SEDGeometry>& geometry,
                                 const glm::dmat4& matrix = glm::dmat4(1.0));
  std::shared_ptr<Transform> add(const TriangleSoup& soup, const glm::dmat4& matrix = glm::dmat4(1.0));

  /// Collects, uploads, draws and fetches. @return "" or what went wrong
  std::string draw(const std::vector<Light>& lights);

  const std::vector<VETRange>& getRanges() const { return this->collector.getCollection().ranges; }

  GpuWindow window;
  Group root;
  VETCollector collector;
  TriangleDrawable triangles;
  SilhouetteCamera camera;
};

/// Whether GLSL has it, as shaders/precise.glsl asks for. @pre  a context is current
bool hasExactArithmetic();

/// 1, -1 or 0: the light is in front of the triangle, behind it, or in its plane.
int facingOf(const LightFacing& facing, std::size_t triangle);

/// What the camera and exact arithmetic make of the same triangles and light.
struct FacingComparison
{
  std::size_t triangles = 0;
  std::size_t different = 0;
  double largestDistance = 0.0; ///< of the light from the plane of one that differs, relative to its distance
                                ///< from the triangle

  void add(const FacingComparison& other);
};

/// Compares the fetched facing of a range with computeFacing(). @pre the light was drawn
FacingComparison compareFacing(const SilhouetteCamera& camera, const VETRange& range, const Light& light);

} // namespace shadow::test
