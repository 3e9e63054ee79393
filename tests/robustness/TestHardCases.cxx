// Runs every hard case through every way to render it, and holds the masks against the truth.
#include <algorithm>
#include <ostream>
#include <string>
#include <utility>

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

/// Hides the actors that the pass has to refuse, from the truth.
class WithoutRefused
{
public:
  explicit WithoutRefused(const HardScene& theScene) : scene(theScene) { this->setVisible(false); }
  ~WithoutRefused() { this->setVisible(true); }

private:
  void setVisible(bool visible) const
  {
    for (vtkActor* actor : this->scene.refused)
    {
      actor->SetVisibility(visible);
    }
  }

  const HardScene& scene;
};

truth::SceneTruth makeTruth(HardScene& scene, int light)
{
  const WithoutRefused hidden(scene);
  return scene.makeTruth(light);
}

/// Whether there is enough of both for a wrong mask to be noticed.
void expectLightAndShadow(const truth::SceneTruth& truth)
{
  const std::vector<unsigned char>& mask = truth.mask().mask();
  const auto dark = std::count(mask.begin(), mask.end(), static_cast<unsigned char>(0));
  EXPECT_GE(dark, 100) << "the scene shows no shadow";
  EXPECT_GE(static_cast<std::ptrdiff_t>(mask.size()) - dark, 100) << "the scene shows nothing that is lit";
}

void expectStatus(HardScene& scene, const char* refusal)
{
  if (refusal == nullptr)
  {
    EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_OK) << scene.pass->GetStatusMessage();
    return;
  }
  EXPECT_EQ(scene.pass->GetStatus(), vtkShadowVolumePass::STATUS_PARTIAL);
  EXPECT_NE(scene.pass->GetStatusMessage().find(refusal), std::string::npos)
      << "'" << scene.pass->GetStatusMessage() << "' does not say '" << refusal << "'";
}

void expectAllLit(HardScene& scene, int light)
{
  const std::vector<unsigned char> mask = scene.renderMask(light);
  EXPECT_EQ(std::count(mask.begin(), mask.end(), static_cast<unsigned char>(255)),
            static_cast<std::ptrdiff_t>(mask.size()))
      << "refused light " << light << " has a shadow";
}

/// One light, by every method that can be right.
void expectTrueLight(HardScene& scene, const HardCase& hardCase, int light)
{
  const truth::SceneTruth truth = makeTruth(scene, light);
  if (hardCase.isMixed)
  {
    expectLightAndShadow(truth);
  }
  for (const truth::ShadowMethod& method : truth::everyMethod(scene.pass))
  {
    if (method.stencil == vtkShadowVolumePass::STENCIL_ZPASS && !hardCase.zPassIsRight)
    {
      continue;
    }
    method.use(scene.pass);
    truth::expectTrueMask(scene, truth, "Light" + std::to_string(light) + method.getName(), light);
    expectStatus(scene, hardCase.refusal);
  }
}

void expectTrueLights(HardScene& scene, const HardCase& hardCase)
{
  scene.window->Render();
  const auto lights = static_cast<int>(truth::lightsFromRenderer(scene.renderer).size());
  for (int light = 0; light < lights; ++light)
  {
    if (scene.refusedLights.count(light) != 0)
    {
      expectAllLit(scene, light);
    }
    else
    {
      expectTrueLight(scene, hardCase, light);
    }
  }
}

std::vector<HardCase> allCases()
{
  std::vector<HardCase> cases;
  for (const auto& some : {lightAtMeshCases(), lightInViewCases(), cameraCases(), viewCases(), meshCases(),
                           coincidentCases(), numberCases(), overlapCases(), badInputCases()})
  {
    cases.insert(cases.end(), some.begin(), some.end());
  }
  return cases;
}

} // namespace

class HardCases : public testing::TestWithParam<HardCase>
{
};

TEST_P(HardCases, EveryMethodIsRightOrRefuses)
{
  HardScene scene;
  GetParam().build(scene);
  expectTrueLights(scene, GetParam());
}

// A sliver is hit by no ray, and drawn in some pixels all the same, as are the sides of its volume, since
// rasterisers move corners to a grid of 1/256 pixel. The size of the window decides in which.
TEST(SliverCases, WindowsOfOtherSizes_EveryMethodIsRight)
{
  const std::vector<HardCase> cases = meshCases();
  const auto thinnest =
      std::find_if(cases.begin(), cases.end(),
                   [](const HardCase& hardCase) { return hardCase.name == std::string("ThinnestSlivers"); });
  ASSERT_NE(thinnest, cases.end());
  for (const auto& [width, height] : {std::pair(640, 480), std::pair(517, 389)})
  {
    SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height));
    HardScene scene;
    scene.window->SetSize(width, height);
    thinnest->build(scene);
    expectTrueLights(scene, *thinnest);
  }
}

INSTANTIATE_TEST_SUITE_P(Table, HardCases, testing::ValuesIn(allCases()),
                         [](const auto& test) { return std::string(test.param.name); });

} // namespace shadow::robustness
