#include "OutlineScene.h"

#include <cstdio>
#include <stdexcept>

#include <gtest/gtest.h>

#include <vtkImageData.h>

#include "SceneFromRenderer.h"

namespace shadow::truth
{

namespace
{

/// Some pixels, each with its distances to what may be and to what certainly is an edge.
std::string describe(const OutlineTruth& truth, const std::vector<glm::ivec2>& pixels)
{
  constexpr std::size_t most = 8;
  std::string text;
  for (std::size_t i = 0; i < pixels.size() && i < most; ++i)
  {
    const auto [x, y] = std::array<int, 2>{pixels[i].x, pixels[i].y};
    char line[128];
    std::snprintf(line, sizeof line, "  (%d, %d) %.3f from an edge, %.3f from a certain one", x, y,
                  truth.distance(x, y), truth.certainDistance(x, y));
    text += (i == 0 ? "" : "\n") + std::string(line);
  }
  return text + (pixels.size() > most ? "\n  ..." : "");
}

} // namespace

OutlineScene::OutlineScene(int width, int height) : ShadowScene(width, height)
{
  this->renderer->SetPass(this->outlines);
}

OutlineTruth OutlineScene::makeOutline(const OutlineOptions& options)
{
  return OutlineTruth(sceneFromRenderer(this->renderer), viewFromRenderer(this->renderer), options);
}

std::vector<unsigned char> OutlineScene::renderLines(double lineWidth)
{
  this->outlines->SetLineWidth(lineWidth);
  this->window->Render();
  vtkNew<vtkImageData> image;
  if (!this->outlines->GetLineMask(image))
  {
    throw std::runtime_error("no line mask: " + this->outlines->GetStatusMessage());
  }
  const auto* pixels = static_cast<const unsigned char*>(image->GetScalarPointer());
  return {pixels, pixels + image->GetNumberOfPoints()};
}

void expectTrueLines(OutlineScene& scene, const OutlineTruth& truth, const std::string& what)
{
  for (const double width : judgedWidths())
  {
    const OutlineError error = compareOutline(truth, scene.renderLines(width), width);
    const std::string name = what + "Width" + std::to_string(static_cast<int>(width));
    std::printf(
        "%-24s %7.4f %% of %5zu certain pixels drawn, %7.4f %% of %5zu drawn pixels right, %zu spikes\n",
        name.c_str(), 100.0 * error.completeness(), error.certain, 100.0 * error.correctness(), error.drawn,
        error.spikes);
    testing::Test::RecordProperty(name + "Drawn", std::to_string(error.completeness()));
    testing::Test::RecordProperty(name + "Right", std::to_string(error.correctness()));
    EXPECT_EQ(scene.outlines->GetStatus(), vtkSilhouettePass::STATUS_OK)
        << scene.outlines->GetStatusMessage();
    EXPECT_GE(error.completeness(), leastRightLines) << name << " misses\n"
                                                     << describe(truth, error.firstMissing);
    EXPECT_GE(error.correctness(), leastRightLines) << name << " has too much\n"
                                                    << describe(truth, error.firstExtra);
    EXPECT_EQ(error.spikes, 0u) << name << " has spikes among\n" << describe(truth, error.firstExtra);
  }
}

} // namespace shadow::truth
