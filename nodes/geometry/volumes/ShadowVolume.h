#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "FacingBits.h"
#include "SEDGeometry.h"

namespace shadow
{

/// The most that an 8-bit stencil buffer can count.
inline constexpr std::size_t mostCountable = 255;

/// Which triangles of a mesh cast.
enum class Casting
{
  LightFacing,  ///< closed mesh, light outside it: only the triangles that face the light
  EveryTriangle ///< any other mesh: every triangle, each turned to face the light; those with the light in
                ///< their plane cast nothing
};

/// A directed edge of the boundary between light and shadow.
struct SilhouetteEdge
{
  std::uint32_t from; ///< vertex; the edge is wound as the casting triangle, turned to the light, winds it
  std::uint32_t to;   ///< vertex
  std::uint32_t multiplicity; ///< 1 or 2: how many quads it stands for
};

/// The faces of one caster's shadow volume for one light, as indices into the vertices of its SEDGeometry.
///
/// Each vertex v exists twice: index 2v is the near copy at the vertex, 2v + 1 the far copy, moved along the
/// ray from the light to infinity or to a plane behind everything that receives shadows. Triangles are wound
/// counter-clockwise seen from outside the volume, except those in lightCapReversed.
struct ShadowVolume
{
  using Triangle = std::array<std::uint32_t, 3>;

  Casting casting = Casting::EveryTriangle;
  std::vector<Triangle> sides;            ///< two a quad; one where the far copies coincide
  std::vector<Triangle> doubledSides;     ///< those of edges with multiplicity 2: each counts twice
  std::vector<Triangle> lightCap;         ///< near copies in raster order, counter-clockwise from outside
  std::vector<Triangle> lightCapReversed; ///< near copies in raster order, clockwise from outside: a cap must
                                          ///< keep the raster order of the surface it lies on, so its stencil
                                          ///< operations are swapped instead of its vertices
  std::vector<Triangle> darkCap;          ///< far copies; empty where they coincide
  std::vector<Triangle> doubledDarkCap;   ///< each counts twice
  std::size_t silhouetteEdges = 0;        ///< with multiplicity
  std::size_t overlapBound = 0;           ///< no ray from the light enters the volume more often than this

  /// Faces of the volume that are made with rays of their own, see CloseTriangles.h.
  struct ClosePart
  {
    std::vector<glm::vec4> vertices; ///< what the indices below are into: w = 1 near and w = 0 far copies of
                                     ///< vertices, w = -1 directions of rays from the light to the far end
    std::vector<Triangle> sides;
    std::vector<Triangle> doubledSides;
    std::vector<Triangle> darkCap;

    std::size_t getTriangleCount() const
    {
      return this->sides.size() + this->doubledSides.size() + this->darkCap.size();
    }
  };
  ClosePart close;

  /// Triangles held.
  std::size_t getTriangleCount() const
  {
    return this->sides.size() + this->doubledSides.size() + this->lightCap.size() +
           this->lightCapReversed.size() + this->darkCap.size() + this->doubledDarkCap.size() +
           this->close.getTriangleCount();
  }

  /// Triangles to count: those of multiplicity 2 twice.
  std::size_t getSideCount() const
  {
    return this->sides.size() + this->close.sides.size() +
           2 * (this->doubledSides.size() + this->close.doubledSides.size());
  }
  std::size_t getCapCount() const
  {
    return this->lightCap.size() + this->lightCapReversed.size() + this->darkCap.size() +
           2 * this->doubledDarkCap.size() + this->close.darkCap.size();
  }
};

/// How the far end of a shadow volume is closed.
enum class DarkCap
{
  None,      ///< z-pass, or the far end cannot be seen
  Triangles, ///< the thesis's: the averted triangles of a closed mesh, or each casting triangle's far copy
  Fan ///< a fan over the far silhouette: as many triangles as edges; at infinity it needs the light outside
      ///< the bounding sphere. Where a triangle is close to the light Triangles are taken in its place
};

/// What a volume is wanted for.
struct ShadowVolumeOptions
{
  bool lightCap = true;
  DarkCap darkCap = DarkCap::Triangles;
  bool farAtInfinity = true;             ///< the far copies for a directional light then coincide
  std::size_t countable = mostCountable; ///< the most that the buffer which counts the volume can count
};

/// How each triangle faces a light. Decided once, and exactly: where rounding could change the sign, exact
/// arithmetic takes over. Two triangles in one plane therefore always agree.
///
/// A light that is not finite leaves all triangles with neither bit.
///
/// @param lightMC  light position relative to the geometry's origin, in model units (w = 1), or the direction
///                 towards a directional light (w = 0)
/// @pre            the light's coordinates are zero or of magnitude 1e-150 to 1e150
/// @par Cost       O(triangles); reads 16 bytes a triangle
/// @par Source     Shi 2006, chapter 3.1; Shewchuk 1997, see ExactOrientation.h
LightFacing computeFacing(const SEDGeometry& geometry, const glm::dvec4& lightMC);

/// The same, in the memory that @p facing has.
void computeFacing(const SEDGeometry& geometry, const glm::dvec4& lightMC, LightFacing& facing);

/// Casting::LightFacing when that is enough for this mesh and light: the mesh is closed and the light is
/// outside its bounding box, as every directional light is. Inside the box the light may be inside the mesh,
/// and Casting::EveryTriangle is right everywhere.
Casting chooseCasting(const SEDGeometry& geometry, const glm::dvec4& lightMC);

/// Turns a silhouette into the faces of the shadow volume.
///
/// @param silhouette  as found by a silhouette method for the same @p facing and @p casting
/// @post  without caps the sides' near edges are the silhouette; with both caps the volume is a closed
/// surface:
///        each edge is run through as often forwards as backwards, once lightCapReversed is turned and, for a
///        directional light at infinity, all far copies are taken as one point
/// @post  overlapBound is the number of casting triangles, or boundOverlap() where that is more than
/// countable
/// @par Cost    O(silhouette), plus O(triangles) when caps are wanted or the light is in the bounding box
/// @par Source  Everitt & Kilgard 2002, "Practical and Robust Stenciled Shadow Volumes"
ShadowVolume extrudeSilhouette(const SEDGeometry& geometry, const std::vector<SilhouetteEdge>& silhouette,
                               const LightFacing& facing, Casting casting, const glm::dvec4& lightMC,
                               const ShadowVolumeOptions& options);

} // namespace shadow
