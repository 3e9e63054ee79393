#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace shadow::fuzz
{

/// Corners in world space.
using FuzzTriangle = std::array<glm::dvec3, 3>;

/// One actor.
struct FuzzMesh
{
  /// World space. The actor's own points are these taken back through the matrix, and rounded to single
  /// precision unless FuzzScene::doublePoints.
  std::vector<FuzzTriangle> triangles;
  glm::dmat4 worldFromMC{1.0};
};

/// As vtkCamera has it.
struct FuzzCamera
{
  glm::dvec3 position{0.0, 0.0, 1.0}, focalPoint{0.0}, viewUp{0.0, 1.0, 0.0};
  double viewAngle = 40.0;             ///< degrees
  std::optional<double> parallelScale; ///< none: a perspective view
  glm::dvec2 clippingRange{0.1, 10.0};
};

/// As vtkLight has it.
struct FuzzLight
{
  bool positional = true;
  double coneAngle = 180.0; ///< degrees; 90 and more: a point light
  glm::dvec3 position{0.0}, focalPoint{0.0};
};

/// Values of vtkShadowVolumePass.
struct FuzzConfig
{
  int stencil = 0, silhouette = 0, compositing = 0, countBuffer = 0;
  bool alone = false; ///< each mesh is drawn by itself, its volumes in all of the view: no savings

  bool operator==(const FuzzConfig& other) const
  {
    return this->stencil == other.stencil && this->silhouette == other.silhouette &&
           this->compositing == other.compositing && this->countBuffer == other.countBuffer &&
           this->alone == other.alone;
  }
};

/// A scene with one light, as it stands in a case's file.
struct FuzzScene
{
  std::string name, kind, why, expected;
  glm::ivec2 size{160, 120}; ///< of the window in pixels
  std::vector<FuzzMesh> meshes;
  bool doublePoints = false;
  bool sharedPoints = false; ///< equal points of an actor are one point, else each triangle has its own
  FuzzCamera camera;
  FuzzLight light;

  /// How it is drawn wrong, or how else to draw it; besides Auto and z-fail.
  std::vector<FuzzConfig> configs;

  std::size_t getTriangleCount() const
  {
    std::size_t count = 0;
    for (const FuzzMesh& mesh : this->meshes)
    {
      count += mesh.triangles.size();
    }
    return count;
  }
};

} // namespace shadow::fuzz
