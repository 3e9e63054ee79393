#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "FacingBits.h"
#include "PlaneKernel.h"
#include "SEDGeometry.h"
#include "ScaledLight.h"

namespace shadow
{

/// Decides how the triangles of chosen words of FacingBits face one light, exactly: what the rounded
/// planes cannot tell is decided from the corners in double precision, and what that cannot tell in exact
/// arithmetic.
///
/// @par Source  Shewchuk 1997, see ExactOrientation.h
class FacingDecider
{
public:
  /// @param lightMC  as for computeFacing()
  FacingDecider(const SEDGeometry& geometry, const glm::dvec4& lightMC,
                InstructionSet set = getInstructionSets().back());

  /// False when the light is not finite or has no direction: then no triangle has a bit.
  bool isLit() const { return this->light.bound > 0.0f; }

  const ScaledLight& getScaledLight() const { return this->light; }

  /// Has compare() and compareClusters() take triangles for doubtful, too, whose planes the light is this
  /// close to.
  ///
  /// @param margin  of the sum of the light's coordinates, where a position's are in units of the reach
  void widenDoubt(double margin);

  /// Writes the words [firstWord, endWord) of @p facing, which is as large as the mesh.
  ///
  /// @pre       isLit()
  /// @par Cost  reads 0.5 KB a word, and 50 ns to a few microseconds for each triangle close to the light's
  /// plane
  void decide(std::size_t firstWord, std::size_t endWord, LightFacing& facing) const;

  /// @name  decide() in two steps, for quarters of words here and there
  /// @{

  /// Bit q of @p quarters stands for the triangles from 16 q on of a word.
  ///
  /// @pre   the bits of these triangles are clear
  /// @post  they are set, but for triangles that the rounded planes cannot tell, which are appended to
  /// @p doubtful
  void compare(std::size_t word, unsigned int quarters, LightFacing& facing,
               std::vector<std::uint32_t>& doubtful) const;

  /// compare() for all quarters that do not face the light as one, by the geometry's ClusterTree.
  ///
  /// @param facing  of any size; its mixedWords are written, too
  /// @par Cost  O(clusters that do not face the light as one), and one store a word
  void compareClusters(LightFacing& facing, std::vector<std::uint32_t>& doubtful) const;

  /// Decides these triangles, from their corners.
  void resolve(const std::vector<std::uint32_t>& doubtful, LightFacing& facing) const;

  /// @}

private:
  void decideOpen(std::size_t word, std::uint64_t open, LightFacing& facing,
                  std::vector<std::uint32_t>& doubtful) const;
  int findSign(std::uint32_t triangle) const;

  const SEDGeometry& geometry;
  glm::dvec4 lightMC;
  ScaledLight light;
  glm::dvec4 lightAsRounded; ///< the same, for double precision
  LightInUnits lightInUnits;
  PlaneKernel kernel;
};

} // namespace shadow
