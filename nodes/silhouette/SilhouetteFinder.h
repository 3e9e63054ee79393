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
  BruteForce = 0, ///< facing of every triangle, then every edge (Shi 2006, chapter 3.2)
  // On the GPU, see nodes/drawable:
  FacingTexture,         ///< facing drawn into a texture and read back (Shi 2006, chapter 3.3)
  FacingTextureResident, ///< the same without reading it back
  VertexTexture,         ///< state of every edge drawn into a texture (Brabec & Seidel 2003)
  VertexExtrusion,       ///< every edge a quad (McGuire & Hughes 2004)
  Compute                ///< silhouette edges listed by compute shaders
};

/// Whether the method runs on the GPU.
inline bool isOnGPU(SilhouetteMethod method)
{
  return method >= SilhouetteMethod::FacingTexture;
}

/// Finds the boundary between light and shadow on a mesh. One subclass for each published method.
class SilhouetteFinder
{
public:
  virtual ~SilhouetteFinder() = default;

  /// Directed edges that bound the casting triangles, wound as these wind them.
  ///
  /// Casting::LightFacing: the boundary of the light-facing part, multiplicity 1.
  /// Casting::EveryTriangle: the boundary of the sum of all triangles, each turned to face the light:
  /// multiplicity 1 on a border and beside a triangle with the light in its plane, 2 where the facing
  /// changes.
  ///
  /// @param facing  see computeFacing(). A triangle with neither bit (the light in its plane) is averted for
  ///                Casting::LightFacing and does not cast for Casting::EveryTriangle
  /// @post  as many edges (with multiplicity) leave each vertex as arrive there, for any facing: on a closed
  /// mesh
  ///        with Casting::LightFacing, on every mesh with Casting::EveryTriangle. Vertices that were split
  ///        from one another count as one
  virtual std::vector<SilhouetteEdge> find(const SEDGeometry& geometry, const LightFacing& facing,
                                           Casting casting) const = 0;
};

/// The method's name on a command line: "brute-force".
std::string toString(SilhouetteMethod method);

/// A finder for the method.
std::unique_ptr<SilhouetteFinder> makeSilhouetteFinder(SilhouetteMethod method);

} // namespace shadow
