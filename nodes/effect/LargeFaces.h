#pragma once

#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "ContributingFaces.h"

namespace shadow
{

/// How many pixels a straight line across the view covers for a unit of its length, in the middle of a mesh,
/// or a quarter of its box's half depth before the eye where the middle is nearer; 0 when all of the box is
/// behind the eye.
///
/// @param clipFromMC  to clip space as VTK draws, from positions relative to the geometry's origin
double measurePixels(const SEDGeometry& geometry, const glm::dmat4& clipFromMC, int width, int height);

/// The faces of a mesh that are long enough to be large on the screen, among which the shader finds those
/// that it draws as three thin triangles. Kept until the scale is another one by a factor of the root of two:
/// a view that moves to and fro about any scale finds them once.
///
/// @par Source  Valient, "Hardware Generated Object Silhouettes", section 4, where it is left to whoever
/// makes the mesh
class LargeFaces
{
public:
  /// @param pixels     measurePixels()
  /// @param lineReach  pixels around an edge that may be drawn
  /// @par Cost      O(1), or O(faces) where the scale has changed
  void find(const SEDGeometry& geometry, const ContributingFaces& contributing, double pixels,
            double lineReach);
  void clear();

  const std::vector<FaceRun>& getRuns() const { return this->runs; }

  /// Model space: a face may be split when it has an edge of this length or more. The largest number: none
  /// is.
  float getLength() const;

private:
  std::optional<float> length; ///< that runs are made for
  std::vector<FaceRun> runs;
};

} // namespace shadow
