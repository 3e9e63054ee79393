#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ShadowVolume.h"

namespace shadow
{

/// The silhouette methods a user can choose from.
enum class SilhouetteMethod
{
  BruteForce = 0 ///< facing of every triangle, then every edge (Shi 2006, chapter 3.2)
};

/// Finds the boundary between light and shadow on a mesh. One subclass for each published method.
class SilhouetteFinder
{
public:
  virtual ~SilhouetteFinder() = default;

  /// Directed edges that bound the casting triangles, wound as these wind them.
  ///
  /// Casting::LightFacing: the boundary of the light-facing part, multiplicity 1.
  /// Casting::EveryTriangle: the boundary of the sum of all triangles, each turned to face the light:
  /// multiplicity 1 on a border, 2 where the facing changes.
  ///
  /// @param facing  see computeFacing(); a triangle with the light in its plane counts as averted
  /// @post  every vertex has as many outgoing as incoming edges (with multiplicity) on a closed mesh, for any facing
  virtual std::vector<SilhouetteEdge> find(const SEDGeometry& geometry, const LightFacing& facing,
                                           Casting casting) const = 0;
};

/// The method's name on a command line: "brute-force".
std::string toString(SilhouetteMethod method);

/// A finder for the method.
std::unique_ptr<SilhouetteFinder> makeSilhouetteFinder(SilhouetteMethod method);

} // namespace shadow
