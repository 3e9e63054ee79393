#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <glm/glm.hpp>

namespace shadow
{

/// Turns and cuts triangles until they are oriented manifold surfaces, which share as many edges as they can.
///
/// Triangles are turned to agree across every edge that two of them share. Where three or more meet in an
/// edge, they are paired: first within a surface, and so that a pair encloses solid; who is left gets a
/// border. Cut edges and vertices where several fans of triangles meet receive their own copies of the
/// vertices.
///
/// One case stays: after the cuts, two edges may still run between the same two vertices.
///
/// @par Source  Guéziec et al. 2001, "Cutting and Stitching: Converting Sets of Polygons to Manifold
/// Surfaces"
class ManifoldSplitter
{
public:
  using Triangle = std::array<std::uint32_t, 3>;

  /// @param triangles  three different vertices each; turned and renumbered in place
  /// @param positions  of the vertices; copies are appended
  ManifoldSplitter(std::vector<Triangle>& triangles, std::vector<glm::vec3>& positions);

  /// @par Cost  O(triangles), but for a sort of the edges at each vertex; about 40 bytes a triangle
  void run();

  /// One entry a triangle: 1 when it was turned.
  const std::vector<std::uint8_t>& getFlipped() const { return this->flipped; }

  std::size_t getSplitVertices() const { return this->splitVertices; }

  /// Pairs of vertices with three or more triangles.
  std::size_t getNonManifoldEdges() const { return this->crowds.size(); }

private:
  /// Side s = 3 * t + k runs in triangle t from corner k to corner (k + 1) % 3, as given, before any turn.
  using Side = std::uint32_t;

  static constexpr Side none = std::numeric_limits<Side>::max();

  /// Sides that join the same two vertices: a range of sortedSides.
  struct Crowd
  {
    std::size_t begin;
    std::size_t end;
  };

  std::uint32_t vertexAt(Side side) const { return this->triangles[side / 3][side % 3]; }
  std::uint32_t vertexAfter(Side side) const { return this->triangles[side / 3][(side + 1) % 3]; }
  bool runsUpwards(Side side) const;
  bool agree(Side a, Side b) const;
  void pair(Side a, Side b);

  void sortSides();
  void pairSimpleEdges(std::size_t begin, std::size_t end);
  void orient();
  std::size_t orientSurface(std::uint32_t seed, std::uint32_t surface, std::vector<std::uint32_t>& members);
  void pairCrowds();
  void pairCrowd(const Crowd& crowd);
  void pairEnclosing(const std::vector<Side>& ring);
  double angleOf(Side side) const;
  void renumber();
  void labelFan(std::uint32_t corner, std::uint32_t label, std::vector<Triangle>& renumbered) const;
  void applyTurns();

  std::vector<Triangle>& triangles;
  std::vector<glm::vec3>& positions;
  std::vector<Side> sortedSides;       ///< sides that join the same two vertices stand together
  std::vector<Side> partner;           ///< the side across the edge, or none
  std::vector<std::uint32_t> surfaces; ///< surface of each triangle: what simple edges connect
  std::vector<std::uint8_t> flipped;
  std::vector<Crowd> crowds;
  std::size_t splitVertices = 0;
};

} // namespace shadow
