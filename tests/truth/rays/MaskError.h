#pragma once

#include <cstddef>
#include <vector>

#include "MaskTruth.h"

namespace shadow::truth
{

/// How a shadow mask differs from the truth.
struct MaskError
{
  static constexpr std::size_t reportedPixels = 32;

  std::size_t pixels = 0;
  std::size_t certain = 0;      ///< certain pixels of the view; 0 unless the comparison was full
  std::size_t wrong = 0;        ///< pixels that differ from the truth
  std::size_t wrongCertain = 0; ///< of these, the certain ones
  double wrongCertainPerMillion =
      0.0; ///< of the certain pixels when the comparison was full, else of all pixels

  /// Distance in pixels from each pixel of either shadow boundary to the other boundary. A boundary pixel has
  /// one of its four neighbours on the other side of the shadow's edge. When only one mask has a boundary,
  /// the diagonal of the view stands for the distance.
  double outlineMean = 0.0;
  double outlineMax = 0.0;

  std::vector<glm::ivec2>
      firstWrongPixels; ///< wrong and certain, row by row from below, at most reportedPixels
};

/// Compares a mask with the truth.
///
/// @param mask  MaskTruth::width() * height() values, lowest row first: 0 in shadow, 255 reached; between the
/// two,
///              128 and above count as reached
/// @param full  casts four more camera rays for every pixel once per truth, to count the certain ones;
/// otherwise
///              only the wrong pixels are examined
/// @throws std::invalid_argument  when the mask has another size
MaskError compareMask(const MaskTruth& truth, const std::vector<unsigned char>& mask, bool full);

} // namespace shadow::truth
