// Real meshes on a floor, held against the truth by every method.
#include <array>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include <vtkOBJReader.h>

#include "ExpectTrueMask.h"
#include "MeshFiles.h"

namespace shadow::truth
{

namespace
{

enum class LightKind
{
  Point,
  Directional
};

using Size = std::array<int, 2>;
using MeshView = std::tuple<std::string, Size, LightKind>; // file, pixels, light

std::string nameOf(const testing::TestParamInfo<MeshView>& info)
{
  const auto& [file, size, light] = info.param;
  return test::toTestName(file) + (light == LightKind::Point ? "_Point_" : "_Directional_") +
         std::to_string(size[0]) + "x" + std::to_string(size[1]);
}

/// Over the viewer's left shoulder, half as high again as the mesh is large.
void addLight(ShadowScene& scene, LightKind kind)
{
  std::array<double, 6> bounds{};
  scene.renderer->ComputeVisiblePropBounds(bounds.data());
  const glm::dvec3 lower(bounds[0], bounds[2], bounds[4]);
  const glm::dvec3 upper(bounds[1], bounds[3], bounds[5]);
  const glm::dvec3 way(0.45, -1.0, -0.3);
  const glm::dvec3 position = 0.5 * (lower + upper) - 1.5 * glm::distance(lower, upper) * way;
  if (kind == LightKind::Point)
  {
    scene.addPointLight(position.x, position.y, position.z);
  }
  else
  {
    scene.addDirectionalLight(way.x, way.y, way.z);
  }
}

} // namespace

class MeshTruth : public testing::TestWithParam<MeshView>
{
};

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(MeshTruth);

TEST_P(MeshTruth, OnAFloor_EveryMethodIsRight)
{
  const auto& [file, size, kind] = GetParam();
  ShadowScene scene(size[0], size[1]);
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(file.c_str());
  scene.addSource(reader);
  addLight(scene, kind);
  scene.lookFrom(0.4, 0.5, 1.0, 1.9);
  scene.addFloor();
  scene.renderer->ResetCameraClippingRange();
  expectTrueMaskByEveryMethod(scene);
}

INSTANTIATE_TEST_SUITE_P(Models, MeshTruth,
                         testing::Combine(testing::ValuesIn(test::findMeshFiles(SHADOW_MODELS)),
                                          testing::Values(Size{640, 480}, Size{1280, 720}),
                                          testing::Values(LightKind::Point, LightKind::Directional)),
                         nameOf);

} // namespace shadow::truth
