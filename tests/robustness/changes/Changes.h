#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ChangingScene.h"

namespace shadow::fuzz
{

/// Something that a program may do to a scene between two pictures.
struct Change
{
  std::string name;
  std::function<void(ChangingScene&, FuzzRandom&)> apply;
};

/// Of props and what they are drawn from.
std::vector<Change> listPropChanges();

/// Of lights.
std::vector<Change> listLightChanges();

/// Of cameras, windows, renderers and the pass.
std::vector<Change> listViewChanges();

} // namespace shadow::fuzz
