#include "SavingsRun.h"

#include <array>
#include <cstddef>
#include <stdexcept>

#include "Timing.h"

namespace shadow::benchmarks
{

namespace
{

using Pass = vtkShadowVolumePass;

struct Flag
{
  const char* name;
  int value;
};

/// All there are, which savingsDrawers() checks.
constexpr std::array<Flag, 3> flags = {{{"kept-masks", Pass::SAVINGS_KEPT_MASKS},
                                        {"batches", Pass::SAVINGS_BATCHES},
                                        {"scissor", Pass::SAVINGS_SCISSOR}}};

std::vector<std::pair<std::string, long long>> countWork(Pass* pass)
{
  return {{"triangles", pass->GetPrePassTriangles() + pass->GetTotalTriangles()},
          {"counted pixels", pass->GetCountedPixels()},
          {"rebuilt volumes", pass->GetNumberOfRebuiltVolumes()},
          {"casters", pass->GetNumberOfCasters()},
          {"kept lights", pass->GetNumberOfKeptLights()},
          {"batched meshes", pass->GetNumberOfBatchedMeshes()}};
}

} // namespace

const std::vector<SavingsDrawer>& savingsDrawers()
{
  static const std::vector<SavingsDrawer> drawers = []
  {
    std::vector<SavingsDrawer> made = {{"all", Pass::SAVINGS_ALL}};
    int known = 0;
    for (const Flag& flag : flags)
    {
      made.push_back({std::string("no ") + flag.name, Pass::SAVINGS_ALL & ~flag.value});
      known |= flag.value;
    }
    if (known != Pass::SAVINGS_ALL)
    {
      throw std::logic_error("bench_savings does not know all savings");
    }
    made.push_back({"none", Pass::SAVINGS_NONE});
    return made;
  }();
  return drawers;
}

SavingsRow measureSavings(const SavingsSceneSize& size, Moves moves, int width, int height, int rounds)
{
  SavingsScene scene(size, width, height);
  const std::vector<SavingsDrawer>& drawers = savingsDrawers();
  std::vector<vtkSmartPointer<Pass>> passes;
  for (const SavingsDrawer& drawer : drawers)
  {
    passes.push_back(vtkSmartPointer<Pass>::New());
    passes.back()->SetSavings(drawer.savings);
  }
  std::vector<double> plain;
  std::vector<double> map;
  std::vector<std::vector<double>> milliseconds(drawers.size());
  SavingsRow row;
  row.scene = size;
  row.moves = moves;
  row.samples.resize(drawers.size());
  // The first round makes what later ones have.
  for (int round = 0; round <= rounds; ++round)
  {
    const double plainFrame = scene.draw(nullptr, moves);
    const double mapFrame = scene.draw(scene.shadowMap, moves);
    for (std::size_t i = 0; i < drawers.size(); ++i)
    {
      const double frame = scene.draw(passes[i], moves);
      if (passes[i]->GetStatus() != Pass::STATUS_OK)
      {
        throw std::runtime_error(size.name + ": " + passes[i]->GetStatusMessage());
      }
      if (round > 0)
      {
        milliseconds[i].push_back(frame);
      }
      row.samples[i].work = countWork(passes[i]);
    }
    if (round > 0)
    {
      plain.push_back(plainFrame);
      map.push_back(mapFrame);
    }
  }
  row.plain = median(plain);
  row.map = median(map);
  for (std::size_t i = 0; i < drawers.size(); ++i)
  {
    row.samples[i].milliseconds = median(milliseconds[i]);
    passes[i]->ReleaseGraphicsResources(scene.scene.window);
  }
  return row;
}

} // namespace shadow::benchmarks
