#include "KeptFrames.h"

#include <array>
#include <cstddef>
#include <filesystem>

#include <benchmark/benchmark.h>

#include <vtkCamera.h>
#include <vtkCubeSource.h>

#include "ShadowScene.h"
#include "Timing.h"

namespace shadow::benchmarks
{

namespace
{

/// What moves from one frame to the next.
enum class Moves
{
  Nothing,
  Camera,
  Light
};

/// Props on a floor under four lights, 640 x 480.
class FourLights
{
public:
  FourLights() : scene(640, 480)
  {
    this->scene.pass->SetSavings(vtkShadowVolumePass::SAVINGS_NONE);
  }
  ~FourLights() { this->scene.renderer->SetPass(nullptr); }
  FourLights(const FourLights&) = delete;
  FourLights& operator=(const FourLights&) = delete;

  /// @pre all props are there
  void light()
  {
    double bounds[6];
    this->scene.renderer->ComputeVisiblePropBounds(bounds);
    const glm::dvec3 lower(bounds[0], bounds[2], bounds[4]);
    const glm::dvec3 upper(bounds[1], bounds[3], bounds[5]);
    this->size = glm::distance(lower, upper);
    this->above = 0.5 * (lower + upper) + glm::dvec3(0.0, this->size, 0.0);
    this->scene.addFloor();
    this->scene.lookFrom(-0.4, 0.7, 1.0, 1.0);
    for (int i = 0; i < 4; ++i)
    {
      vtkLight* added = this->scene.addPointLight(this->above.x + 0.4 * this->size * (i % 2 == 0 ? 1.0 : -1.0),
                                                  this->above.y, this->above.z + 0.3 * this->size * (i - 1.5));
      added->SetIntensity(0.3);
      this->moving = added;
    }
  }

  /// Milliseconds of a frame by a pass that has drawn the one before.
  double draw(vtkRenderPass* pass, Moves moves)
  {
    this->scene.renderer->SetPass(pass);
    this->scene.window->Render();
    this->turn += 0.01;
    if (moves == Moves::Camera)
    {
      this->scene.renderer->GetActiveCamera()->Azimuth(0.3);
    }
    if (moves == Moves::Light)
    {
      this->moving->SetPosition(this->above.x + this->turn * this->size, this->above.y, this->above.z);
    }
    return measure(
        [this]
        {
          this->scene.window->Render();
          this->scene.window->WaitForCompletion();
        });
  }

  truth::ShadowScene scene; ///< its pass keeps nothing
  vtkNew<vtkShadowVolumePass> keeping;

private:
  glm::dvec3 above{0.0};
  double size = 1.0;
  double turn = 0.0;
  vtkLight* moving = nullptr;
};

void addThousandBoxes(truth::ShadowScene& scene)
{
  for (int i = 0; i < 1000; ++i)
  {
    vtkNew<vtkCubeSource> box;
    box->SetCenter(1.7 * (i % 32), 0.5, 1.7 * (i / 32));
    scene.addSource(box);
  }
}

void keptFrames(benchmark::State& state, const std::function<void(truth::ShadowScene&)>& addProps, Moves moves)
{
  FourLights four;
  addProps(four.scene);
  four.light();
  const std::array<vtkRenderPass*, 3> passes = {nullptr, four.scene.pass, four.keeping};
  std::array<std::vector<double>, 3> milliseconds;
  std::vector<double> scene;
  for (auto _ : state)
  {
    for (std::size_t i = 0; i < passes.size(); ++i)
    {
      milliseconds[i].push_back(four.draw(passes[i], moves));
    }
    scene.push_back(four.keeping->GetSceneMilliseconds());
    state.SetIterationTime(1e-3 * milliseconds[2].back());
  }
  const double plain = median(milliseconds[0]);
  const double anew = median(milliseconds[1]);
  const double kept = median(milliseconds[2]);
  state.counters["plain_ms"] = plain;
  state.counters["anew_ms"] = anew;
  state.counters["kept_ms"] = kept;
  state.counters["kept_over_plain"] = kept / plain;
  state.counters["kept_over_anew"] = kept / anew;
  state.counters["scene_ms"] = median(scene);
  state.counters["lights_kept"] = four.keeping->GetNumberOfKeptLights();
}

void registerScene(const std::string& name, const std::function<void(truth::ShadowScene&)>& addProps)
{
  const std::array<const char*, 3> names = {"still", "camera", "light"};
  for (const Moves moves : {Moves::Nothing, Moves::Camera, Moves::Light})
  {
    const std::string row = "Kept/" + name + "/" + names[static_cast<std::size_t>(moves)];
    benchmark::RegisterBenchmark(row.c_str(), keptFrames, addProps, moves)
        ->UseManualTime()
        ->Iterations(40)
        ->Unit(benchmark::kMillisecond);
  }
}

} // namespace

void registerKeptFrames(const std::vector<std::string>& models,
                        const std::function<vtkSmartPointer<vtkAlgorithm>(const std::string&)>& makeSource)
{
  for (const std::string& model : models)
  {
    registerScene(std::filesystem::path(model).stem().string(),
                  [=](truth::ShadowScene& scene) { scene.addSource(makeSource(model)); });
  }
  registerScene("boxes-1000", addThousandBoxes);
}

} // namespace shadow::benchmarks
