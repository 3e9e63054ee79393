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

/// A scene with changes of its own.
struct Sequence
{
  Sequence(std::uint64_t seed, std::uint64_t number) : random(seed, number), scene(random) {}

  /// @return what the change is called
  std::string change()
  {
    const Change& change = pickChange(this->random);
    change.apply(this->scene, this->random);
    return change.name;
  }

  truth::DrawnShadows draw() { return truth::drawShadows(this->scene.window, this->scene.pass); }
  truth::DrawnShadows drawAnew() { return truth::drawByNewPass(this->scene.window, this->scene.pass); }

  FuzzRandom random;
  ChangingScene scene;
};

} // namespace

SequenceResult runSequence(std::uint64_t seed, std::uint64_t number, int changes)
{
  Sequence keeping(seed, number);
  Sequence twin(seed, number); // has lived through the same, and keeps nothing
  SequenceResult result;
  std::string since = "as it begins";
  int untilCheck = 0;
  for (int i = 0; i <= changes && result.fault.empty(); ++i)
  {
    if (i > 0)
    {
      since += (since.empty() ? "change " : "; ") + std::to_string(i) + ": " + keeping.change();
      twin.change();
    }
    twin.scene.pass->SetSavings(vtkShadowVolumePass::SAVINGS_NONE);
    truth::DrawnShadows drawn = keeping.draw();
    result.changes = i;
    result.lights += keeping.scene.pass->GetNumberOfShadowLights();
    result.keptLights += keeping.scene.pass->GetNumberOfKeptLights();
    std::string differences = truth::tellDifferences(drawn, twin.draw());
    const bool isChecked = untilCheck-- <= 0 || i == changes;
    if (isChecked)
    {
      ++result.checks;
      const truth::DrawnShadows anew = keeping.drawAnew();
      twin.drawAnew();
      // VTK does not always build an actor's shader anew where it should, with our passes and without: where a
      // texture is taken away, or actors with edges and without share a mapper. A new pass has it built anew; the
      // twin has the same past.
      drawn.picture = anew.picture;
      differences += truth::tellDifferences(drawn, anew);
      untilCheck = keeping.random.integer(0, mostBetweenChecks - 1);
      twin.random.integer(0, mostBetweenChecks - 1);
    }
    result.fault = differences.empty() ? "" : since + "\n" + differences;
    since = isChecked ? "" : since;
  }
  return result;
}

} // namespace shadow::fuzz
