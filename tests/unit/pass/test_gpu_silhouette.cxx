// Laws of the volumes that are made on the GPU: the silhouette is the CPU's, and volumes are closed.

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "EdgeQuadSilhouette.h"
#include "GeometryShaderSilhouette.h"
#include "TestMeshes.h"
#include "VolumeCounter.h"

using namespace shadow;
using namespace shadow::test;

namespace
{

struct Method
{
  std::string name;
  std::function<std::unique_ptr<GPUSilhouette>()> make;
};

std::string nameOf(const testing::TestParamInfo<Method>& info)
{
  return info.param.name;
}

void PrintTo(const Method& method, std::ostream* stream)
{
  *stream << method.name;
}

class GPUVolume : public testing::TestWithParam<Method>, protected VolumeCounter
{
protected:
  GPUVolume() : VolumeCounter(this->GetParam().make()) {}
};

class GeometryShaderVolume : public GPUVolume
{
};

const Method edgeQuads = {"VertexExtrusion", [] { return std::make_unique<EdgeQuadSilhouette>(); }};
const Method geometryShader = {"GeometryShader", [] { return std::make_unique<GeometryShaderSilhouette>(); }};

/// Lights anywhere; the last are exactly in planes of the axes that some meshes have triangles in.
std::vector<glm::dvec4> makeLights(std::mt19937& random)
{
  return {glm::dvec4(randomPoint(random, 1.0), 1.0), glm::dvec4(randomPoint(random, 5.0), 1.0),
          glm::dvec4(randomPoint(random, 1.0), 0.0), glm::dvec4(0.25, 1.0, 5.0, 1.0),
          glm::dvec4(1.0, 0.0, 0.0, 0.0)};
}

} // namespace

TEST_P(GeometryShaderVolume, Sides_OncePerEdgeOfTheCPUsSilhouette)
{
  std::mt19937 random(11);
  std::size_t edges = 0;
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    this->setMesh(mesh.soup);
    for (const glm::dvec4& light : makeLights(random))
    {
      const std::size_t expected = this->findOnCPU(light).size();
      EXPECT_EQ(this->draw(light, CasterPlan{StencilCount::ZPass}).primitives, 2 * expected)
          << mesh.name << ", light " << light.x << " " << light.y << " " << light.z << " " << light.w;
      edges += expected;
    }
  }
  EXPECT_GT(edges, 1000u);
}

TEST_P(GeometryShaderVolume, Caps_OncePerTriangleThatCasts)
{
  const glm::dvec4 light(0.3, 4.0, 0.2, 1.0);
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    this->setMesh(mesh.soup);
    const glm::dvec4 lightMC = this->toModel(light);
    const LightFacing facing = computeFacing(this->getGeometry(), lightMC);
    const bool lightFacingOnly = chooseCasting(this->getGeometry(), lightMC) == Casting::LightFacing;
    const std::size_t all = this->getGeometry().getTriangles().size();
    const std::size_t casting = facing.towards.countSet() + (lightFacingOnly ? 0 : facing.away.countSet());
    const std::size_t sides = 2 * this->findOnCPU(light).size();
    EXPECT_EQ(this->draw(light, closedPlan(DarkCap::None)).primitives, sides + casting) << mesh.name;
    EXPECT_EQ(this->draw(light, closedPlan(DarkCap::Fan)).primitives, sides + sides / 2 + casting)
        << mesh.name;
    EXPECT_EQ(this->draw(light, closedPlan(DarkCap::Triangles)).primitives,
              sides + casting + (lightFacingOnly ? all - casting : casting))
        << mesh.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, GeometryShaderVolume, testing::Values(geometryShader), nameOf);

TEST_P(GPUVolume, AnyMeshAndLight_ClosedAtBothEnds)
{
  std::mt19937 random(12);
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    this->setMesh(mesh.soup);
    std::vector<glm::dvec4> lights = makeLights(random);
    const std::vector<glm::dvec4> inPlanes = this->makeLightsInPlanes(random);
    lights.insert(lights.end(), inPlanes.begin(), inPlanes.end());
    for (const glm::dvec4& light : lights)
    {
      EXPECT_EQ(this->draw(light, closedPlan(DarkCap::Triangles)).unbalanced, 0u)
          << mesh.name << ", light " << light.x << " " << light.y << " " << light.z << " " << light.w;
    }
  }
}

TEST_P(GPUVolume, EndsLeftOut_IsSeenInTheCount)
{
  this->setMesh(makeTorus(1.0, 0.4, 24, 12));
  // On the eye's side, so that the far end can be seen.
  const glm::dvec4 light(2.0, 3.0, 5.5, 1.0);
  CasterPlan plan = closedPlan(DarkCap::Fan);
  EXPECT_EQ(this->draw(light, plan).unbalanced, 0u);
  plan.lightCap = false;
  EXPECT_GT(this->draw(light, plan).unbalanced, 100u);
  EXPECT_GT(this->draw(light, closedPlan(DarkCap::None)).unbalanced, 100u);
}

TEST_P(GPUVolume, FarPlane_ClosedByAFan)
{
  CasterPlan plan = closedPlan(DarkCap::Fan);
  plan.farPlaneWC = glm::dvec4(0.0, 1.0, 0.0, 2.5);
  std::mt19937 random(13);
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    this->setMesh(mesh.soup);
    for (int round = 0; round < 4; ++round)
    {
      const glm::dvec4 light(randomPoint(random, 1.0) + glm::dvec3(0.0, 5.0, 0.0), round % 2);
      EXPECT_EQ(this->draw(light, plan).unbalanced, 0u)
          << mesh.name << ", light " << light.x << " " << light.y << " " << light.z << " " << light.w;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, GPUVolume, testing::Values(edgeQuads, geometryShader), nameOf);
