#include "MethodCheck.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <mutex>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include <vtkOpenGLRenderWindow.h>

#include "KnownScene.h"
#include "Stopwatch.h"

namespace shadow
{

namespace
{

/// What decides which parts of the GL are used.
using Way = std::tuple<SilhouetteMethod, CountBuffer, int, bool, bool>;

/// The faults that were found, by GL context. VTK numbers contexts by the time at which they were made,
/// which is another for each.
class KnownFaults
{
public:
  std::optional<std::string> find(vtkMTimeType context, const Way& way)
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    const auto entry = this->contexts.find(context);
    if (entry == this->contexts.end() || entry->second.count(way) == 0)
    {
      return std::nullopt;
    }
    return entry->second.at(way);
  }

  void add(vtkMTimeType context, const Way& way, const std::string& fault)
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    this->contexts[context][way] = fault;
    if (this->contexts.size() > most)
    {
      this->contexts.erase(this->contexts.begin()); // the oldest; were it still there, it is checked again
    }
  }

private:
  static constexpr std::size_t most = 100; ///< contexts
  std::mutex mutex;
  std::map<vtkMTimeType, std::map<Way, std::string>> contexts;
};

/// Pixels of a mask that are not as they have to be. Of several samples some may lie on an edge that two faces of
/// a volume share, and count for both or neither: a pixel is wrong when three quarters of them are.
std::size_t countWrong(const std::vector<KnownScene::Answer>& answers, const std::vector<unsigned char>& mask)
{
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < answers.size(); ++i)
  {
    wrong += answers[i] == KnownScene::Answer::Reached && mask[i] < 65 ? 1 : 0;
    wrong += answers[i] == KnownScene::Answer::Shadow && mask[i] > 190 ? 1 : 0;
  }
  return wrong;
}

/// @return the fault, empty when there is none; nothing when the GL refuses to draw
std::optional<std::string> findFault(vtkOpenGLRenderWindow* window, ShadowVolumeEffect& effect,
                                     ShadowVolumeEffect::Settings settings, bool parallelView)
{
  const KnownScene scene(parallelView);
  effect.clearChildren();
  scene.addTo(effect);
  settings.coplanarTolerance = 0.0;
  const int batches = settings.savings;
  settings.findHiddenBacks = false;
  settings.waitAfterStages = false;
  std::vector<std::vector<unsigned char>> masks; // of one light after the other
  std::string refusal;
  // Where meshes are drawn together, large ones are drawn alone all the same.
  std::vector<std::pair<StencilMethod, int>> ways = {{StencilMethod::ZFail, batches}, {StencilMethod::Auto, batches}};
  if (batches != 0)
  {
    ways.emplace_back(StencilMethod::Auto, NoSavings);
  }
  for (const auto& [stencilMethod, savings] : ways)
  {
    settings.stencilMethod = stencilMethod;
    settings.savings = savings;
    if (refusal.empty() &&
        effect.renderMask(window, scene.getView(), scene.getLights(), settings, refusal))
    {
      for (const Light& light : scene.getLights())
      {
        masks.push_back(effect.getTarget().readMask(window, light.index));
      }
    }
  }
  effect.clearChildren();
  effect.clearStatistics();
  if (!refusal.empty())
  {
    return std::nullopt;
  }
  std::size_t wrong = 0;
  for (std::size_t light = 0; light < scene.getLights().size(); ++light)
  {
    const std::vector<KnownScene::Answer> answers = scene.findAnswers(light);
    for (std::size_t mask = light; mask < masks.size(); mask += scene.getLights().size())
    {
      wrong += countWrong(answers, masks[mask]);
    }
  }
  // A rasteriser that rounds otherwise is not wrong: faults of drivers show in whole parts of the scene.
  constexpr std::size_t fewest = 3;
  return wrong < fewest
             ? ""
             : "this GL draws shadows wrongly, as " + std::to_string(wrong) + " pixels of a test tell";
}

} // namespace

MethodCheck checkMethod(vtkOpenGLRenderWindow* window, ShadowVolumeEffect& effect,
                        const ShadowVolumeEffect::Settings& settings, bool parallelView)
{
  static KnownFaults knownFaults;
  const Stopwatch stopwatch;
  const int samples = std::min(settings.samples, effect.getCapabilities().maximumSamples);
  // Methods on the CPU have one way through the GL.
  const SilhouetteMethod method =
      isOnGPU(settings.silhouetteMethod) ? settings.silhouetteMethod : SilhouetteMethod::Auto;
  const bool batched = !isOnGPU(method) && (settings.savings & Batches) != 0;
  const Way way(method, effect.chooseCountBuffer(settings.countBuffer, samples), samples, parallelView, batched);
  const vtkMTimeType context = window->GetContextCreationTime();
  MethodCheck check;
  std::optional<std::string> fault = knownFaults.find(context, way);
  if (!fault)
  {
    ShadowVolumeEffect::Settings checked = settings;
    checked.savings = batched ? Batches : NoSavings;
    fault = findFault(window, effect, checked, parallelView);
    if (fault)
    {
      knownFaults.add(context, way, *fault);
    }
    check.milliseconds = stopwatch.getMilliseconds();
  }
  check.drawn = fault.has_value();
  check.fault = fault.value_or("");
  return check;
}

} // namespace shadow
