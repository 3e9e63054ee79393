#include "ChangeSequence.h"

#include <array>
#include <vector>

#include "Changes.h"
#include "NewPass.h"

namespace shadow::fuzz
{

namespace
{

constexpr int mostBetweenChecks = 5;

/// Lights change more often than there are ways to change them: of all else nothing is kept.
const Change& pickChange(FuzzRandom& random)
{
  static const std::array<std::vector<Change>, 3> changes = {listPropChanges(), listLightChanges(),
                                                             listViewChanges()};
  return random.pick(changes[random.below(changes.size())]);
}

} // namespace

SequenceResult runSequence(std::uint64_t seed, std::uint64_t number, int changes)
{
  FuzzRandom random(seed, number);
  ChangingScene scene(random);
  SequenceResult result;
  std::string since = "change 0: new";
  int untilCheck = 0;
  for (int i = 0; i <= changes && result.fault.empty(); ++i)
  {
    if (i > 0)
    {
      const Change& change = pickChange(random);
      change.apply(scene, random);
      since += (since.empty() ? "change " : "; ") + std::to_string(i) + ": " + change.name;
    }
    const truth::DrawnShadows drawn = truth::drawShadows(scene.window, scene.pass);
    result.changes = i;
    result.lights += scene.pass->GetNumberOfShadowLights();
    result.keptLights += scene.pass->GetNumberOfKeptLights();
    if (untilCheck-- > 0 && i < changes)
    {
      continue;
    }
    ++result.checks;
    const std::string differences = truth::tellDifferences(drawn, truth::drawByNewPass(scene.window, scene.pass));
    result.fault = differences.empty() ? "" : since + "\n" + differences;
    since.clear();
    untilCheck = random.integer(0, mostBetweenChecks - 1);
  }
  return result;
}

} // namespace shadow::fuzz
