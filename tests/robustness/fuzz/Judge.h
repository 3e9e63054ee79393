#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "CertainPixels.h"
#include "SceneWindow.h"

namespace shadow::fuzz
{

/// What is wrong with one drawing of a scene.
struct MaskVerdict
{
  FuzzConfig config;
  std::size_t wrong = 0; ///< certain pixels that differ from the truth
  glm::ivec2 first{-1};  ///< of these, the lowest, leftmost one
  std::string refusal;   ///< as DrawnMask has it
  std::size_t wrongInPicture = 0; ///< as DrawnMask has it
};

/// The gravest first.
enum class Fault
{
  WrongMask,    ///< a mask has more wrong pixels than it may have
  MasksDiffer,  ///< in a certain pixel
  WrongPicture, ///< the two compositings differ in more pixels than a mask may have wrong
  Refused,      ///< the pass did not draw all
  None
};

struct SceneVerdict
{
  std::vector<MaskVerdict> masks;
  std::size_t pixels = 0;
  std::size_t limit = 0;     ///< the most wrong pixels that a mask may have
  std::size_t differing = 0; ///< certain pixels in which two masks differ

  const MaskVerdict& getWorst() const;
  Fault getFault() const;
  bool isWrong() const { return this->getFault() != Fault::None; }
  std::string describe() const;
};

/// 20 in a million, but at least 3.
std::size_t getWrongPixelLimit(std::size_t certainPixels);

/// Holds masks of a scene against the truth and against each other.
///
/// @param masks   of the truth's size
/// @param enough  ends the search as soon as a mask has more wrong pixels than this
/// @par Cost  up to thirteen camera rays for every pixel in which a mask differs from the truth
SceneVerdict judgeMasks(const CertainPixels& truth, const std::vector<DrawnMask>& masks,
                        std::size_t enough = std::numeric_limits<std::size_t>::max());

/// "auto", "zfail silhouette 3 color additive".
std::string getName(const FuzzConfig& config);

} // namespace shadow::fuzz
