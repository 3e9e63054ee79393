#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "EdgeTable.h"
#include "FacingBits.h"
#include "PlaneBlock.h"
#include "ScaledLight.h"

namespace shadow
{

/// Tells for whole words of FacingBits at once that all their triangles face a light, or that none does.
///
/// A cluster is the 64 triangles of a word, and the triangles across the outer edges that belong to the word:
/// where a cluster faces a light as one, none of the edges of its word is on a silhouette. Eight clusters
/// make a node of the next level, and so on. Each node bounds the planes of its triangles by a box of normals
/// (a normal cone with flat sides) and by how far the planes pass from the node's centre.
///
/// @par Memory  about 1 byte a triangle
/// @par Source  Johnson & Cohen 2001, "Spatialized Normal Cone Hierarchies"; Sander et al. 2000, "Silhouette
///              Clipping"
class ClusterTree
{
public:
  ClusterTree() = default;

  /// @param reach  see SEDGeometry::getReach()
  /// @par Cost  O(triangles)
  ClusterTree(const std::vector<PlaneBlock>& planes, const EdgeTable& edges,
              const std::vector<std::array<std::uint32_t, 3>>& triangles,
              const std::vector<glm::vec3>& positions, double reach);

  /// Writes the words of all clusters that face the light as one.
  ///
  /// @param towards,away  of the size of the mesh; words of other clusters are left as they are
  /// @param mixed         the words of other clusters are appended, rising
  /// @post  a triangle whose bits were written faces the light as written, exactly; no corner of it is the
  ///        light rounded to single precision; and so do the triangles across the edges of its word
  /// @par Cost  O(nodes that do not face the light as one), and one store a word
  void classify(const ScaledLight& light, FacingBits& towards, FacingBits& away,
                std::vector<std::uint32_t>& mixed) const;

  /// Bytes held by the arrays.
  std::size_t getMemorySize() const;

private:
  static constexpr std::size_t fan = 8;
  using Lanes = std::array<float, fan>;

  /// Bounds of eight siblings, in the scale of PlaneBlock.
  struct Group
  {
    std::array<Lanes, 3> centre{};
    std::array<Lanes, 3> normalLower{};
    std::array<Lanes, 3> normalUpper{};
    Lanes offsetLower{}; ///< of dot(normal, centre) + offset
    Lanes offsetUpper{};
  };

  struct Bounds;
  struct Walk;

  static void evaluate(const Group& nodes, const ScaledLight& light, Lanes& lower, Lanes& upper);
  std::size_t boundLevel(std::size_t level, std::size_t children);
  void store(std::size_t level, std::size_t node, const Bounds& bounds);
  Bounds load(std::size_t level, std::size_t node) const;
  void visit(std::size_t level, std::size_t group, Walk& walk, std::vector<std::uint32_t>& mixed) const;

  std::vector<std::vector<Group>> levels; ///< [0] clusters; the last one has one group
  std::size_t words = 0;
};

} // namespace shadow
