#pragma once

#include <cstddef>
#include <vector>

#include "Light.h"
#include "Node.h"
#include "View.h"

namespace shadow
{

/// A tiny scene of which it is known what the shadow mask has to be: closed and open meshes, one with an
/// inner wall, one with triangles that are there twice, one mirrored and with a light in the plane of a side,
/// and one in whose shadow the eye is; a point light and a directional one.
class KnownScene
{
public:
  /// Of the picture, in pixels. No power of two, as of windows: see TexelArray::allocate().
  static constexpr int side = 35;

  /// What the mask has to be at a pixel.
  enum class Answer : unsigned char
  {
    Shadow,
    Reached,
    Uncertain ///< an edge is near
  };

  explicit KnownScene(bool parallelView);

  const View& getView() const { return this->view; }
  const std::vector<Light>& getLights() const { return this->lights; }

  /// Adds the scene to @p root. @par Cost  that of building adjacency for 36 triangles
  void addTo(Group& root) const;

  /// side * side answers, bottom row first: what a ray through each of a pixel's corners finds, where all
  /// four find the same.
  /// @param light  place in getLights()
  /// @par Cost  some milliseconds
  std::vector<Answer> findAnswers(std::size_t light) const;

  /// What the ray through a point of the picture, in pixels, finds: Uncertain where the light grazes.
  /// @param object  the one that is seen; -1: none
  Answer findAnswer(const glm::dvec2& pixel, std::size_t light, int& object) const;

private:
  struct Triangle
  {
    glm::dvec3 corners[3];
    int object;
  };
  const Triangle* findFirst(const glm::dvec3& start, const glm::dvec3& ray, double& distance) const;

  View view;
  glm::dmat4 wcFromClip{1.0};
  std::vector<Light> lights;
  std::vector<Triangle> triangles; ///< world space
};

} // namespace shadow
