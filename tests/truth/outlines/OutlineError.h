#pragma once

#include <cstddef>
#include <vector>

#include "OutlineTruth.h"

namespace shadow::truth
{

/// How a mask of lines differs from the truth.
struct OutlineError
{
  static constexpr std::size_t reportedPixels = 32;

  /// How far outside a line a pixel counts as a spike, in pixels.
  static constexpr double spikeTolerance = 1.0;

  std::size_t certain = 0; ///< pixels that a line certainly covers
  std::size_t missing = 0; ///< of these, the ones that are not set
  std::size_t drawn = 0;   ///< pixels that are set
  std::size_t extra = 0;   ///< of these, the ones that no line may cover
  std::size_t spikes = 0;  ///< of these, the ones farther than spikeTolerance outside every line

  /// Row by row from below, at most reportedPixels each.
  std::vector<glm::ivec2> firstMissing, firstExtra;

  /// Shares, 0 to 1; 1 where there is nothing to judge.
  double completeness() const;
  double correctness() const;
};

/// @param mask       OutlineTruth::width() * height() values, lowest row first; 128 and above are line
/// @param lineWidth  pixels, at most OutlineOptions::widest
/// @throws std::invalid_argument  when the mask has another size
OutlineError compareOutline(const OutlineTruth& truth, const std::vector<unsigned char>& mask,
                            double lineWidth);

} // namespace shadow::truth
