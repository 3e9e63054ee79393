#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "PlaneBlock.h"
#include "ScaledLight.h"

namespace shadow
{

/// Ways to compute the same thing on this machine.
enum class InstructionSet
{
  Scalar, ///< one after the other; plain C++
  Vector, ///< vectors of the machine the library was built for
  Avx2    ///< x86 with AVX2, found out at run time
};

/// Those that this processor and this build have, the slowest first.
const std::vector<InstructionSet>& getInstructionSets();

/// Compares planes' values at a light with its bound.
///
/// All instruction sets give the same.
struct PlaneKernel
{
  /// Of whole blocks. Writes a word a block: bits of the triangles whose value is above bound, or below
  /// -bound.
  ///
  /// @par Cost  reads 8 bytes a triangle
  void (*compareBlocks)(const PlaneBlock* blocks, std::size_t count, const LightInUnits& light,
                        std::uint64_t* towards, std::uint64_t* away);

  /// Of chosen quarters of a block: bit q of @p quarters stands for the triangles from 16 q on. Sets bits in
  /// words where those of these triangles are clear.
  void (*compareQuarters)(const PlaneBlock& block, unsigned int quarters, const LightInUnits& light,
                          std::uint64_t& towards, std::uint64_t& away);
};

PlaneKernel getPlaneKernel(InstructionSet set);

} // namespace shadow
