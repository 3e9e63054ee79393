#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "ParallelFor.h"
#include "SEDGeometry.h"
#include "ShadowVolume.h"

namespace shadow
{

/// The silhouette methods a user can choose from.
enum class SilhouetteMethod
{
  Auto = 0,          ///< the faster of BruteForce and Hierarchical for the size of the mesh
  BruteForce,        ///< facing of every triangle, then every edge (Shi 2006, chapter 3.2)
  EdgeBuffer,        ///< triangles flip bits at their edges (Buchanan & Sousa 2000)
  Triangular,        ///< TA: directed edges that cancel (Kolivand & Sunar 2011)
  VisibleNonVisible, ///< VnV: edges with one neighbour that faces the light (Kolivand & Sunar 2011)
  Hybrid,            ///< HSD: TA on polygons merged from coplanar triangles (Kolivand & Sunar 2011)
  Hierarchical,      ///< only clusters of triangles that do not face the light as one
  TopologyAwareMesh, ///< TAM: each triangle compares itself with its neighbours (Valient 2005)
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

  /// The method that is used for a geometry: what makeSilhouetteFinder() was asked for, or what Auto chooses.
  virtual SilhouetteMethod getMethod(const SEDGeometry& geometry) const
  {
    static_cast<void>(geometry);
    return this->method;
  }

  /// How each triangle faces a light, as computeFacing() tells: the same bits whatever the method. find() may
  /// be faster with what the same finder has written here.
  ///
  /// @param lightMC  relative to the geometry's origin; w = 0: direction towards the light
  /// @param facing   its memory is used again
  virtual void face(const SEDGeometry& geometry, const glm::dvec4& lightMC, LightFacing& facing) const
  {
    computeFacing(geometry, lightMC, facing);
  }

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
  /// face(), as with every method that gives the exact silhouette.
  virtual std::optional<LightFacing> simplifyFacing(const SEDGeometry& geometry,
                                                    const LightFacing& facing) const;

private:
  friend std::unique_ptr<SilhouetteFinder>
  makeSilhouetteFinder(SilhouetteMethod method, double coplanarTolerance, ParallelFor parallelFor);

  std::uint64_t id;
  SilhouetteMethod method = SilhouetteMethod::BruteForce;
};

/// Every method, in the order of their values.
const std::vector<SilhouetteMethod>& getSilhouetteMethods();

/// The method's name on a command line: "brute-force".
std::string toString(SilhouetteMethod method);

/// A finder for the method. What it prepares from a geometry is kept with the geometry, see
/// SEDGeometry::getPreparedData().
///
/// @param coplanarTolerance  degrees, for SilhouetteMethod::Hybrid: see HybridSilhouette
/// @param parallelFor        threads for methods that gain from them; none: the calling thread alone
/// @throws std::invalid_argument  for a method that isOnGPU()
std::unique_ptr<SilhouetteFinder>
makeSilhouetteFinder(SilhouetteMethod method, double coplanarTolerance = 0.0, ParallelFor parallelFor = {});

} // namespace shadow
