#pragma once

#include <cstddef>
#include <cstdint>

#include "EdgeTable.h"
#include "PlaneKernel.h"

namespace shadow
{

/// An edge whose triangles differ.
struct DifferingEdge
{
  std::uint32_t first;  ///< triangle
  std::uint32_t side;   ///< of the first triangle, see EdgeTable
  std::uint32_t second; ///< triangle
};

/// Writes edges of the words [firstWord, endWord) whose triangles differ in one of the bits.
///
/// @param towards,away  words of FacingBits; @p away may be null: only @p towards is compared then
/// @param found         room for EdgeTable::mostOfWord edges a word
/// @return              the place behind the last edge written
/// @par Cost            reads 5 bytes and two bits an outer edge, and 2 bytes an inner one of words whose
///                      triangles are not all alike
using EdgeKernel = DifferingEdge* (*)(const EdgeTable& table, const std::uint64_t* towards,
                                      const std::uint64_t* away, std::size_t firstWord, std::size_t endWord,
                                      DifferingEdge* found);

EdgeKernel getEdgeKernel(InstructionSet set);

} // namespace shadow
