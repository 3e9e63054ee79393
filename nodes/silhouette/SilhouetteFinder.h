#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ShadowVolume.h"

namespace shadow
{

/// The silhouette methods a user can choose from.
enum class SilhouetteMethod
{
  BruteForce = 0,    ///< facing of every triangle, then every edge (Shi 2006, chapter 3.2)
  EdgeBuffer,        ///< triangles flip bits at their edges (Buchanan & Sousa 2000)
  Triangular,        ///< TA: directed edges that cancel (Kolivand & Sunar 2011)
  VisibleNonVisible, ///< VnV: edges with one neighbour that faces the light (Kolivand & Sunar 2011)
  Hybrid,            ///< HSD: TA on polygons merged from coplanar triangles (Kolivand & Sunar 2011)
  // On the GPU, see nodes/drawable:
  FacingTexture,         ///< facing drawn into a texture and read back (Shi 2006, chapter 3.3)
  FacingTextureResident, ///< the same without reading it back
  VertexTexture,         ///< state of every edge drawn into a texture (Brabec & Seidel 2003)
  VertexExtrusion,       ///< every edge a quad (McGuire & Hughes 2004)
  GeometryShader,        ///< triangles with adjacency (Zerari & Babahenini 2011)
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
  SilhouetteFinder();
  virtual ~SilhouetteFinder() = default;
  SilhouetteFinder(const SilhouetteFinder&) = delete;
  SilhouetteFinder& operator=(const SilhouetteFinder&) = delete;

  /// Tells finders apart, also from those that are gone: what was found by another one may be different.
  std::uint64_t getId() const { return this->id; }

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

  /// The facing that silhouette and caps are to be made from, where a method simplifies it. Nothing: that of
  /// computeFacing(), as with every method that gives the exact silhouette.
  virtual std::optional<LightFacing> simplifyFacing(const SEDGeometry& geometry,
                                                    const LightFacing& facing) const;

private:
  std::uint64_t id;
};

/// The method's name on a command line: brute-force, edge-buffer, triangular, visible-nonvisible, hybrid.
std::string toString(SilhouetteMethod method);

/// A finder for the method. What it prepares from a geometry is kept with the geometry, see
/// SEDGeometry::getPreparedData().
///
/// @param coplanarTolerance  degrees, for SilhouetteMethod::Hybrid: see HybridSilhouette
std::unique_ptr<SilhouetteFinder> makeSilhouetteFinder(SilhouetteMethod method,
                                                       double coplanarTolerance = 0.0);

} // namespace shadow
