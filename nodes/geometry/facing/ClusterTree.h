#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "EdgeTable.h"
#include "FacingBits.h"
#include "ParallelFor.h"
#include "PlaneBlock.h"
#include "PlaneKernel.h"
#include "ScaledLight.h"

namespace shadow
{

/// Tells for whole quarters of words of FacingBits at once that all their triangles face a light, or that
/// none does.
///
/// A cluster is the 16 triangles of a quarter (see PlaneBlock), and the triangles across those of its edges
/// that belong to it: where a cluster faces a light as one, none of these edges is on a silhouette. Eight
/// clusters make a node of the next level, and so on. Each node bounds the planes of its triangles by a box
/// of normals (a normal cone with flat sides) and by how far the planes pass from the node's centre.
///
/// All in 16 bits, for what a light costs is how many cache lines are looked at.
///
/// @par Memory  about 2 bytes a triangle
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
              const std::vector<glm::vec3>& positions, double reach, const ParallelFor& parallelFor = {});

  /// Quarters of one word.
  struct Quarters
  {
    std::uint32_t word;
    std::uint32_t bits; ///< bit q: the triangles from 16 q on
  };

  /// Writes the bits of all clusters that face the light as one, and clears those of others.
  ///
  /// @param towards,away  of the size of the mesh
  /// @param mixed         the other clusters are appended, words rising
  /// @post  a triangle that has a bit faces the light as written, exactly; no corner of it is the light
  ///        rounded to single precision; and so do the triangles across the edges of its cluster
  /// @par Cost  O(nodes that do not face the light as one), and one store a word
  void classify(const ScaledLight& light, FacingBits& towards, FacingBits& away, std::vector<Quarters>& mixed,
                InstructionSet set = getInstructionSets().back()) const;

  /// Bytes held by the arrays.
  std::size_t getMemorySize() const;

private:
  static constexpr std::size_t fan = 8;
  static constexpr std::size_t quartersOfWord = PlaneBlock::triangles / PlaneBlock::quarter;
  static constexpr std::size_t wordsOfGroup = fan / quartersOfWord;
  using Lanes = std::array<std::int16_t, fan>;

  /// Bounds of eight siblings, in units of PlaneBlock. Three cache lines.
  struct alignas(64) Group
  {
    std::array<Lanes, 3> centre{};
    std::array<Lanes, 3> normalLower{};
    std::array<Lanes, 3> normalUpper{};
    Lanes offsetLower{}; ///< of dot(normal, centre) + offset
    Lanes offsetUpper{};
  };

  /// Children of a group, a bit each.
  struct Sides
  {
    unsigned int towards = 0; ///< all triangles face the light
    unsigned int away = 0;    ///< none does
  };

  struct Bounds;
  struct Walk;

  void boundClusters(std::size_t word, const std::vector<PlaneBlock>& planes, const EdgeTable& edges,
                     const std::vector<std::array<std::uint32_t, 3>>& triangles,
                     const std::vector<glm::vec3>& positions, double reach);
  std::size_t boundLevel(std::size_t level, std::size_t children);
  void store(std::size_t level, std::size_t node, const Bounds& bounds);
  Bounds load(std::size_t level, std::size_t node) const;

  static Sides evaluate(const Group& nodes, const ScaledLight& light);
  static Sides evaluateAvx2(const Group& nodes, const ScaledLight& light);
  void visit(std::size_t level, std::size_t group, Walk& walk, std::vector<std::uint32_t>& mixed) const;
  void visitClusters(std::size_t group, Walk& walk, std::vector<Quarters>& mixed) const;

  std::vector<std::vector<Group>> levels; ///< [0] clusters; the last one has one group
  std::size_t words = 0;
  std::size_t clusters = 0;
};

} // namespace shadow
