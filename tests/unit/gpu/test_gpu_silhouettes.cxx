// The silhouettes that the GPU finds and keeps, read back: those of the CPU, and closed whatever the light.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "ComputeProgram.h"
#include "OpenGL.h"
#include "SilhouetteProbe.h"
#include "TestMeshes.h"

using namespace shadow;
using namespace shadow::test;

namespace
{

constexpr std::uint32_t torusSide = 60;
constexpr std::uint32_t inPlaneLights = 400;

/// Point lights inside and outside the mesh, and directional ones.
std::vector<glm::dvec4> makeLights(std::uint32_t seed, int count)
{
  std::mt19937 random(seed);
  std::vector<glm::dvec4> lights;
  for (int i = 0; i < count; ++i)
  {
    lights.emplace_back(randomPoint(random, i % 3 == 0 ? 0.5 : 6.0), i % 4 == 3 ? 0.0 : 1.0);
  }
  return lights;
}

template <class Method>
void expectThatOfTheCPU(SilhouetteProbe& probe, Method& method, const std::vector<glm::dvec4>& lights)
{
  probe.find(method, lights);
  const SilhouetteProbe::Silhouettes found = probe.read(method);
  ASSERT_EQ(found.size(), lights.size());
  for (std::size_t light = 0; light < lights.size(); ++light)
  {
    EXPECT_TRUE(isSameSilhouette(found[light], findOnCPU(probe.getGeometry(), lights[light]))) << "light " << light;
  }
}

/// Lights of the torus whose silhouette is open by a method.
template <class Method>
std::size_t countOpenSilhouettes(SilhouetteProbe& probe, Method& method)
{
  std::size_t open = 0;
  for (std::uint32_t first = 0; first < inPlaneLights; first += maximumLights)
  {
    std::vector<glm::dvec4> lights;
    for (std::uint32_t place = first; place < std::min(first + maximumLights, inPlaneLights); ++place)
    {
      lights.push_back(makeInPlaneLight(probe.getGeometry(), torusSide, place));
    }
    probe.find(method, lights);
    for (const std::vector<SilhouetteEdge>& silhouette : probe.read(method))
    {
      open += countOpenVertices(probe.getGeometry(), silhouette) > 0 ? 1 : 0;
    }
  }
  return open;
}

SEDGeometry makeTestTorus()
{
  return build(makeTorus(2.0, 0.5, torusSide, torusSide));
}

} // namespace

TEST(VertexTexture, AnyMeshAndLights_SilhouettesOfTheCPU)
{
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    SilhouetteProbe probe(build(mesh.soup));
    for (const auto normals : {VertexTexture::Normals::OncePerTriangle, VertexTexture::Normals::PerEdge})
    {
      VertexTexture method(normals);
      expectThatOfTheCPU(probe, method, makeLights(1, maximumLights));
      expectThatOfTheCPU(probe, method, makeLights(2, 3));
      expectThatOfTheCPU(probe, method, makeLights(2, 3));
      method.release(false);
    }
  }
}

TEST(VertexTexture, TextureSplitOverLayers_SilhouettesOfTheCPU)
{
  SilhouetteProbe probe(makeTestTorus());
  VertexTexture method(VertexTexture::Normals::OncePerTriangle, 32);
  expectThatOfTheCPU(probe, method, makeLights(3, 5));
  EXPECT_GT(method.getEdgeTexels(probe.getPath()).getLayers(), 1);
  method.release(false);
}

TEST(VertexTexture, LightsInThePlaneOfManyTriangles_EverySilhouetteIsClosed)
{
  SilhouetteProbe probe(makeTestTorus());
  for (const auto normals : {VertexTexture::Normals::OncePerTriangle, VertexTexture::Normals::PerEdge})
  {
    VertexTexture method(normals);
    EXPECT_EQ(countOpenSilhouettes(probe, method), 0u);
    method.release(false);
  }
}

// Why the published form is not offered.
TEST(VertexTexture, AsPublished_LightsInThePlaneOfManyTriangles_LeavesSilhouettesOpen)
{
  SilhouetteProbe probe(makeTestTorus());
  VertexTexture method(VertexTexture::Normals::PerEdgeAsPublished);
  expectThatOfTheCPU(probe, method, {glm::dvec4(3.0, 4.0, 5.0, 1.0)});
  const std::size_t open = countOpenSilhouettes(probe, method);
  RecordProperty("OpenSilhouettes", static_cast<int>(open));
  EXPECT_GT(open, inPlaneLights / 20);
  method.release(false);
}

TEST(ComputeSilhouette, AnyMeshAndLights_SilhouettesOfTheCPU)
{
  for (const NamedMesh& mesh : makeAllMeshes())
  {
    SCOPED_TRACE(mesh.name);
    SilhouetteProbe probe(build(mesh.soup));
    if (!probe.canCompute())
    {
      GTEST_SKIP() << "no compute shaders";
    }
    ComputeSilhouette method;
    expectThatOfTheCPU(probe, method, makeLights(1, maximumLights));
    expectThatOfTheCPU(probe, method, makeLights(2, 3));
    expectThatOfTheCPU(probe, method, makeLights(2, 3));
    expectThatOfTheCPU(probe, method, {});
    method.release(false);
  }
}

TEST(ComputeSilhouette, BrokenRowsOfWorkGroupsAndLayers_SilhouettesOfTheCPU)
{
  SilhouetteProbe probe(makeTestTorus());
  if (!probe.canCompute())
  {
    GTEST_SKIP() << "no compute shaders";
  }
  ComputeSilhouette method(7, 32);
  expectThatOfTheCPU(probe, method, makeLights(4, 5));
  method.release(false);
}

TEST(ComputeSilhouette, LightsInThePlaneOfManyTriangles_EverySilhouetteIsClosed)
{
  SilhouetteProbe probe(makeTestTorus());
  if (!probe.canCompute())
  {
    GTEST_SKIP() << "no compute shaders";
  }
  ComputeSilhouette method;
  EXPECT_EQ(countOpenSilhouettes(probe, method), 0u);
  method.release(false);
}

TEST(ComputeProgram, BadSource_SaysWhyEachTime)
{
  SilhouetteProbe probe(build(makeCube()));
  if (!probe.canCompute())
  {
    GTEST_SKIP() << "no compute shaders";
  }
  ComputeProgram broken("#version 430\nlayout(local_size_x = 1) in; void main() { nonsense(); }",
                        "broken.comp");
  ComputeProgram unlinkable(
      "#version 430\nlayout(local_size_x = 1) in; void absent(); void main() { absent(); }",
      "unlinkable.comp");
  for (int time = 0; time < 2; ++time)
  {
    std::string error;
    EXPECT_FALSE(broken.use(probe.getWindow(), error));
    EXPECT_NE(error.find("broken.comp does not compile"), std::string::npos) << error;
    EXPECT_NE(error.find("nonsense"), std::string::npos) << error;
    EXPECT_FALSE(unlinkable.use(probe.getWindow(), error));
    EXPECT_NE(error.find("unlinkable.comp does not link"), std::string::npos) << error;
  }
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}
