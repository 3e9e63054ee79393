// Runs every hard case through every way to render it, and holds the masks against the truth.
#include <algorithm>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "ExpectTrueMask.h"
#include "HardCase.h"
#include "HardScene.h"
#include "SceneFromRenderer.h"

namespace shadow::robustness
{

// For GoogleTest, which would print its bytes.
void PrintTo(const HardCase& hardCase, std::ostream* os)
{
  *os << hardCase.name;
}

namespace
{

/// The truth of a scene in which there are no actors that the pass has to refuse.
truth::SceneTruth makeTruthWithoutRefused(HardScene& scene, int light)
{
  for (vtkActor* actor : scene.refused)
  {
    actor->VisibilityOff();
  }
  truth::SceneTruth truth = scene.makeTruth(light);
  for (vtkActor* actor : scene.refused)
  {
    actor->VisibilityOn();
  }
  return truth;
}

} // namespace
} // namespace shadow::robustness
