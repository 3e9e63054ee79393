#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include <vtkHeadlessRenderWindow.h>
#include <vtkNew.h>

#include "ComputeSilhouette.h"
#include "SEDGeode.h"
#include "ShadowVolume.h"
#include "VertexTexture.h"

namespace shadow::test
{

/// A window whose context is current, in which the methods of the GPU find the silhouettes of one mesh, to be
/// read back.
class SilhouetteProbe
{
public:
  explicit SilhouetteProbe(const SEDGeometry& geometry);
  SilhouetteProbe(const SilhouetteProbe&) = delete;
  SilhouetteProbe& operator=(const SilhouetteProbe&) = delete;

  /// Has a method find the silhouettes of these lights, in model space relative to the geometry's origin;
  /// light i has index i. Throws std::runtime_error with what the GL says.
  void find(GPUSilhouette& method, const std::vector<glm::dvec4>& lightsMC);

  /// What a method found last: one list of edges, in no order, for each light.
  using Silhouettes = std::vector<std::vector<SilhouetteEdge>>;
  Silhouettes read(const VertexTexture& method) const;
  Silhouettes read(const ComputeSilhouette& method) const;

  bool canCompute() const; ///< see Capabilities
  const NodePath& getPath() const { return this->path; }
  vtkHeadlessRenderWindow* getWindow() { return this->window; }
  const SEDGeometry& getGeometry() const { return this->geode.getGeometry(); }

private:
  std::vector<std::uint32_t> readWords(const TexelArray& texels) const;

  mutable vtkNew<vtkHeadlessRenderWindow> window; ///< reading back changes its state
  SEDGeode geode;
  PathState state;
  NodePath path;
  View view;
  std::vector<Light> lights;
};

/// Vertices that a silhouette leaves more often than it arrives there, or the other way round; none for one
/// that is closed. Vertices at the same position count as one.
std::size_t countOpenVertices(const SEDGeometry& geometry, const std::vector<SilhouetteEdge>& silhouette);

/// Whether two silhouettes are the same edges, in any order.
bool isSameSilhouette(std::vector<SilhouetteEdge> a, std::vector<SilhouetteEdge> b);

/// What the CPU finds.
std::vector<SilhouetteEdge> findOnCPU(const SEDGeometry& geometry, const glm::dvec4& lightMC);

/// A light in the plane of many triangles of a torus of makeTorus(2, 0.5, n, n), for place 0 to 399: for even
/// places where the planes of a ring's squares meet, on the axis; for odd ones in the plane of one square.
glm::dvec4 makeInPlaneLight(const SEDGeometry& torus, std::uint32_t n, std::uint32_t place);

} // namespace shadow::test
