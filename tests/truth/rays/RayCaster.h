#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "TriangleTests.h"
#include "TruthBvh.h"
#include "TruthScene.h"

namespace shadow::truth
{

/// What a camera ray sees.
enum class Answer : unsigned char
{
  Background, ///< no triangle
  Reached,    ///< a point that the light reaches
  Shadowed    ///< a point in shadow, or on a side turned away from the light
};

/// Where a camera ray meets the nearest visible triangle.
struct Hit
{
  std::uint32_t triangle = 0; ///< in Scene::triangles
  std::uint32_t position = 0; ///< in the caster's own order
  double distance = 0.0;      ///< from the ray's origin
  glm::dvec3 point{0.0};      ///< caster's space
  int eyeSide = 0;            ///< side of the triangle that the camera sees, see sideOfPlane()
};

/// The light in the caster's space.
struct LocalLight
{
  glm::dvec4 position;
  double rounding;
};

/// Casts rays in double precision: the truth against which shadows are judged.
///
/// The light reaches the nearest hit P when P's visible side faces it and no casting triangle but the one hit
/// crosses the open segment from P to the light (w = 1) or the ray towards it (w = 0). Both sides of a
/// triangle block. A light in the plane of P's triangle does not face it, and a light with a zero direction
/// faces nothing.
///
/// P lies on its triangle only up to rounding. A triangle therefore blocks when its plane has P and the light
/// strictly on opposite sides, where strictly means farther than rounding reaches. A coincident duplicate, a
/// coplanar neighbour, and a neighbour whose edge or corner P lies on, have P in their plane and never block.
/// The price is a band of rounding width (8 units in the last place of the coordinates) beside the lines
/// along which surfaces touch.
class RayCaster
{
public:
  explicit RayCaster(const Scene& scene);

  /// World position of the origin of Ray and Hit. On a grid coarse enough that vertices move there without
  /// rounding.
  const glm::dvec3& originWC() const { return this->origin; }

  LocalLight localLight(const Light& light) const;

  /// @par Cost  O(log triangles) typically
  std::optional<Hit> firstHit(const Ray& ray) const;

  bool isReached(const Hit& hit, const LocalLight& light) const;

  Answer answer(const Ray& ray, const LocalLight& light) const;

  /// Whether a visible triangle crosses the open segment from the ray's origin to a point of the ray, by the
  /// rules by which triangles block light: one whose plane the point lies in does not.
  ///
  /// @param point          caster's space; off by no more than @p pointRounding
  /// @param without        two triangles, in Scene::triangles, that are not asked
  bool isCovered(const glm::dvec3& point, double pointRounding, const Ray& ray,
                 const std::array<std::uint32_t, 2>& without) const;

private:
  bool isBlocked(const Hit& hit, const LocalLight& light) const;

  glm::dvec3 origin{0.0};
  std::vector<LocalTriangle> triangles; ///< in the order of the hierarchy's leaves
  TruthBvh bvh;
};

/// The point in which the ray meets the triangle beyond its origin, by the rules of RayCaster; for one
/// triangle. Hit::position is left 0.
std::optional<Hit> hitTriangle(const LocalTriangle& triangle, const Ray& ray);

/// Whether the triangle crosses the open segment from a point to the light, by the rules of RayCaster;
/// whether it casts or not.
/// @param direction  from the point to the light
bool separates(const LocalTriangle& triangle, const glm::dvec3& point, double pointRounding,
               const glm::dvec3& direction, const LocalLight& light);

/// The same for triangles that cast.
bool blocks(const LocalTriangle& triangle, const glm::dvec3& point, double pointRounding,
            const glm::dvec3& direction, const LocalLight& light);

} // namespace shadow::truth
