#pragma once

#include <cstdint>
#include <string>

namespace shadow::fuzz
{

/// What became of a sequence of changes.
struct SequenceResult
{
  int changes = 0;     ///< drawn
  int checks = 0;      ///< against new passes
  int lights = 0;      ///< with shadows, over all renderings
  int keptLights = 0;  ///< of these, those whose mask was kept
  std::string fault;   ///< the last changes, and what differs then; empty when nothing does
};

/// Changes a random scene again and again and draws it after each change. Masks and picture have to be those of a
/// scene of the same past whose pass keeps nothing, and every few changes the masks those of a new pass, to the
/// bit. Ends at the first that differ.
///
/// @param number  of the sequence
SequenceResult runSequence(std::uint64_t seed, std::uint64_t number, int changes);

} // namespace shadow::fuzz
