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

/// How a topology-aware mesh lies in memory.
enum class TAMLayout
{
  Full,  ///< three vertices a face, 84 bytes each: position, three corners, three normals, all float32
  Half,  ///< the same with corners and normals as halves, corners in units of the mesh's reach: 48 bytes each
  Shared ///< what is common to a face once, in a buffer that shaders fetch from: three normals of 4 bytes,
         ///< see packNormal(), or what getFate() knows, see neverPacked and borderPacked. Positions and
         ///< corners are the original mesh's own vertex and index buffer
};

/// What is known of an edge of a face before there is any eye.
enum class EdgeFate
{
  Open,   ///< the face and its neighbour may face an eye differently
  Border, ///< it has no neighbour: a border line whatever the eye is
  Never   ///< no line whatever the eye is, or one that the neighbour has
};

/// The edges of a face that are lines.
struct FaceEdges
{
  std::uint32_t face;
  std::uint32_t edges; ///< bit k: between the corners k and (k + 1) % 3 in raster order; bit 3 + k: it is a
                       ///< crease, with the surface on both of its sides unless bit k is set, too

  bool operator==(const FaceEdges& other) const
  {
    return this->face == other.face && this->edges == other.edges;
  }
};

/// Valient's structure: each face knows its corners and how its neighbours are turned, so that whoever looks
/// at one face alone can tell which of its edges are on the silhouette.
///
/// Faces, corners and edges are those of the SEDGeometry it was made from: face t is triangle t, corners are
/// in raster order, edge k joins the corners k and (k + 1) % 3.
///
/// An edge without a neighbour has the negated normal of its own face: by the paper's comparison, which the
/// layouts Full and Half are made for, it is always on the silhouette. findLines() and the layout Shared know
/// borders as such, to be drawn or not.
///
/// Where three or more triangles meet in an edge, SEDGeometry has paired them: each pair is an edge with two
/// faces, and who is left has a border there, always drawn. Two faces that are left and run through the edge
/// the same way, as where a surface that cannot be oriented is cut, are neighbours of which each sees the
/// other turned over: they are on the silhouette when they face the eye as one.
///
/// A copy of a triangle that counts (see SEDGeometryOptions::copiesCountOnce) is a face without lines: it has
/// its own normal at every edge.
///
/// A face without area has no side. It takes the normal and the facing of the face across its longest edge,
/// so that a T-junction which such a face closes draws no line across a smooth surface. Over other such faces
/// the search goes on; two that have their longest edge in common are left across another one. Where that
/// leads to a border, or nowhere, the surface ends: such a face has no side, and neither it nor a neighbour
/// has a line there but the border.
///
/// Lasts on its own; functions that also need positions are handed the geometry it was made from.
///
/// @par Memory  24 bytes a face
/// @par Source  Valient, "Hardware Generated Object Silhouettes", section 2
class TopologyAwareMesh
{
public:
  /// @par Cost  O(triangles)
  explicit TopologyAwareMesh(const SEDGeometry& geometry);

  std::size_t countFaces() const { return this->normals.size(); }

  /// The face across an edge, or noTriangle on a border and where the neighbour is turned over.
  std::uint32_t getNeighbour(std::size_t face, std::size_t edge) const
  {
    return this->neighbours[face][edge];
  }

  /// The face's own normal, as it is oriented: of length 1, or zero where none stands in for it.
  const glm::vec3& getNormal(std::size_t face) const { return this->normals[face]; }

  /// The normal stored for an edge: the neighbour's, that of a neighbour that is turned over negated, or the
  /// negated own one on a border. Zero where the neighbour has none.
  glm::vec3 getNeighbourNormal(std::size_t face, std::size_t edge) const;

  /// What is known of an edge without an eye.
  ///
  /// That of a copy is never a line. It is never a line when its faces, or those that stand in for them, lie exactly in one plane and look to
  /// the same side of it: every eye then sees both from the same side. Nor is it where one of them has no
  /// side. Of a face without area no edge but its borders is a line: what other lines there are its
  /// neighbours have, which store the normal from beyond it. Only between two such faces that have their
  /// sides from different faces may a line be lost.
  ///
  /// A concave edge is not among them. Of a solid seen from outside it is hidden, but a hidden line may be
  /// asked for, the eye may be inside, and the near plane may cut away what hides it.
  ///
  /// @par Cost    O(1); O(log(faces without area)) beside one of these
  /// @par Source  Valient, section 4: faces that cannot contribute are left out
  EdgeFate getFate(const SEDGeometry& geometry, std::size_t face, std::size_t edge) const;

  /// Gives each face without area the bits of the face that stands in for it. Every facing that is handed to
  /// findLines() has to be completed; LightFacing::mixedWords stays right.
  void completeFacing(LightFacing& facing) const;

  /// Which edges are lines.
  struct LineKinds
  {
    bool silhouette = true;
    bool border = true;
    const std::vector<FaceEdges>* creases = nullptr; ///< findCreases(); drawn whatever their facing is
  };

  /// The edges that are lines for an eye, each once: it belongs to the lower one of its faces.
  ///
  /// An edge is on the silhouette when one of its faces looks towards the eye and the other one does not; a
  /// face with the eye in its plane does not. Where a face has no side, none of its edges is.
  ///
  /// @param facing  towards the eye, as computeFacing() or a SilhouetteFinder gives it, and completed
  /// @param lines   is overwritten; rising by face
  /// @par Cost      O(edges of facing.mixedWords, or of the mesh, + borders + creases)
  void findLines(const SEDGeometry& geometry, const LightFacing& facing, const LineKinds& kinds,
                 std::vector<FaceEdges>& lines) const;

  /// The edges whose faces' normals are more than an angle apart. Borders are none, nor are edges within a
  /// plane, however rounding turns normals.
  /// @param degrees  0 to 180
  /// @par Cost       O(edges)
  std::vector<FaceEdges> findCreases(const SEDGeometry& geometry, double degrees) const;

  /// The mesh as a GPU takes it: see TAMLayout.
  std::vector<unsigned char> pack(const SEDGeometry& geometry, TAMLayout layout) const;

  /// Bytes of pack().
  std::size_t getPackedSize(TAMLayout layout) const;

  /// Bytes that this object holds.
  std::size_t getMemorySize() const;

private:
  struct StandIn
  {
    std::uint32_t face;   ///< without area
    std::uint32_t source; ///< with one
  };
  class StandInSearch;
  /// Two sides, 3 * face + edge, of faces that are turned over to one another.
  struct TurnedPair
  {
    std::uint32_t side;
    std::uint32_t other;
  };
  void linkNeighbours(const SEDGeometry& geometry);
  void pairBorders(const SEDGeometry& geometry);
  void findStandIns(const SEDGeometry& geometry);
  std::uint32_t getTurnedNeighbour(std::size_t face, std::size_t edge) const; ///< or noTriangle
  bool hasSide(std::size_t face) const { return this->normals[face] != glm::vec3(0.0f); }

  /// The face whose side a face has: its own, that of who stands in for it, or noTriangle.
  std::uint32_t getSource(std::size_t face) const;

  /// Two faces with an area, in exactly one plane and on the same side of it, or one and the same.
  static bool lieAlike(const SEDGeometry& geometry, std::uint32_t face, std::uint32_t other);
  void removeWithoutSide(std::vector<FaceEdges>& lines) const;

  std::vector<std::array<std::uint32_t, 3>> neighbours;
  std::vector<glm::vec3> normals;
  std::vector<std::uint32_t> borders;  ///< sides without a neighbour, rising
  std::vector<TurnedPair> turnedPairs; ///< each twice, rising by side
  std::vector<StandIn> standIns;       ///< rising by face
  FacingBits copies; ///< of the geometry
  bool allHaveSides = true;
};

/// Bytes of the mesh that a topology-aware mesh is held against: 44 for each vertex (position, normal,
/// tangent, texture coordinates) and three indices a face, of 2 bytes for up to 65,535 vertices and of 4
/// beyond.
///
/// @par Source  Valient, section 2.1. Its 1.53 and 0.77 are 144 and 72 bytes over 94 a face, which takes two
/// vertices a face; a closed mesh of welded vertices has half a vertex a face, and is smaller than that
std::size_t getOriginalSize(std::size_t vertices, std::size_t faces);

/// A direction in 32 bits, octahedral, 16 bits a coordinate.
/// @param normal  length 1; all zeros are packed as +z
/// @post  unpackNormal() gives a direction less than 1e-4 off
/// @par Source  Meyer et al. 2010, "On Floating-Point Normal Vectors"
std::uint32_t packNormal(const glm::vec3& normal);
glm::vec3 unpackNormal(std::uint32_t packed);

/// Stand in the shared layout where no normal is needed: an edge that is never a line, and a border. No
/// normal is packed so.
inline constexpr std::uint32_t neverPacked = 0x80008000u;
inline constexpr std::uint32_t borderPacked = 0x80000000u;

} // namespace shadow
