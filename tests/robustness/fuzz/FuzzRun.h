#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "FuzzReport.h"
#include "FuzzSession.h"

namespace shadow::fuzz
{

struct FuzzOptions
{
  std::uint64_t scenes = 300;
  std::uint64_t seed = 1;
  std::uint64_t first = 0; ///< number of the first scene
  int jobs = 1;
  std::string output = "."; ///< folder for the cases of wrong scenes
  bool shrinks = true;
  bool everyMethod = false; ///< draws every scene by every method, not by four of them dealt by its number
  bool lists = false;       ///< a line on every scene, not on wrong ones alone
};

/// Draws a scene and judges it; when it is wrong, makes it small and writes it.
SceneLine runScene(FuzzSession& session, const FuzzOptions& options, std::uint64_t number);

/// Draws the scenes of the options in that many processes, and says what is wrong as it is found.
///
/// @return whether all are right
bool runScenes(const FuzzOptions& options);

} // namespace shadow::fuzz
