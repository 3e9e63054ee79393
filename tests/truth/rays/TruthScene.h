#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

namespace shadow::truth
{

/// One triangle of the scene, world space. Front is where its vertices run counter-clockwise on the screen.
struct Triangle
{
  glm::dvec3 a{0.0}, b{0.0}, c{0.0};
  std::uint32_t part = 0; ///< only triangles of one part are neighbours of one another
  bool casts = true;
  bool hideFront =
      false; ///< not seen by the camera from its front (VTK's FrontfaceCulling); casts all the same
  bool hideBack = false; ///< not seen by the camera from its back (VTK's BackfaceCulling); casts all the same
};

/// Any triangle soup. Triangles with a coordinate that is not finite are neither seen nor cast.
struct Scene
{
  std::vector<Triangle> triangles;
};

/// A camera and its window.
struct View
{
  /// World to clip space, column vectors. Only the near plane (z = -w) cuts: nothing in front of it is seen,
  /// and what lies beyond the far plane is seen. @pre invertible
  glm::dmat4 clipFromWC{1.0};
  int width = 0;  ///< pixels
  int height = 0; ///< pixels
};

struct Light
{
  glm::dvec4 positionWC{0.0}; ///< w = 1: position; w = 0: direction towards the light, any length
};

/// A half-line in the space of a RayCaster: world axes, origin at RayCaster::originWC().
struct Ray
{
  glm::dvec3 origin{0.0};    ///< on the near plane
  glm::dvec3 direction{0.0}; ///< unit length
  /// +1 when a front face has its counter-clockwise normal along the direction, else -1 (views that do not
  /// mirror)
  double frontSign = -1.0;
};

} // namespace shadow::truth
