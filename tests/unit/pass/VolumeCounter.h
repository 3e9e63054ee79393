#pragma once

#include <cstddef>
#include <memory>
#include <random>
#include <vector>

#include <glm/glm.hpp>

#include <vtkHeadlessRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include "DrawableCache.h"
#include "GPUSilhouette.h"
#include "SEDGeode.h"
#include "TestMeshes.h"

namespace shadow::test
{

/// Draws volumes by one method into a buffer of counts without a depth test. A closed volume counts to zero
/// in every pixel, or, where it holds the eye and the near plane cuts its surface off, to the same in every
/// pixel.
class VolumeCounter
{
public:
  struct Drawn
  {
    std::size_t primitives = 0; ///< triangles behind the geometry shader
    std::size_t unbalanced = 0; ///< pixels whose count is not that of the eye
  };

  explicit VolumeCounter(std::unique_ptr<GPUSilhouette> silhouette);
  ~VolumeCounter();
  VolumeCounter(const VolumeCounter&) = delete;
  VolumeCounter& operator=(const VolumeCounter&) = delete;

  void setMesh(const TriangleSoup& soup);
  const SEDGeometry& getGeometry() const { return this->geode->getGeometry(); }
  glm::dvec4 toModel(const glm::dvec4& lightWC) const;

  /// What the CPU makes of the same light.
  std::vector<SilhouetteEdge> findOnCPU(const glm::dvec4& lightWC) const;

  Drawn draw(const glm::dvec4& lightWC, const CasterPlan& plan);

  /// A volume closed at both ends.
  static CasterPlan closedPlan(DarkCap darkCap);

  /// Lights in the planes of some of the mesh's triangles, as far as rounding lets them be.
  std::vector<glm::dvec4> makeLightsInPlanes(std::mt19937& random) const;

private:
  void drawVolume(const glm::dvec4& lightWC, const CasterPlan& plan);

  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkHeadlessRenderWindow> window;
  std::unique_ptr<GPUSilhouette> method;
  DrawableCache drawables;
  std::shared_ptr<SEDGeode> geode;
  View view;
  unsigned int framebuffer = 0;
  unsigned int counts = 0;
  unsigned int query = 0;
};

} // namespace shadow::test
