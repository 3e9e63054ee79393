// Laws of the volumes that are made on the GPU: the silhouette is the CPU's, and volumes are closed.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <vtkHeadlessRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include "BruteForceSilhouette.h"
#include "DrawableCache.h"
#include "EdgeQuadSilhouette.h"
#include "GeometryShaderSilhouette.h"
#include "OpenGL.h"
#include "SEDGeode.h"
#include "TestMeshes.h"

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

/// Draws volumes by one method into a buffer of counts without a depth test. A closed volume counts to zero
/// in every pixel, or, where it holds the eye and the near plane cuts its surface off, to the same in every
/// pixel.
class GPUVolume : public testing::TestWithParam<Method>
{
protected:
  static constexpr int side = 160; ///< pixels

  struct Drawn
  {
    std::size_t primitives = 0; ///< triangles behind the geometry shader
    std::size_t unbalanced = 0; ///< pixels whose count is not that of the eye
  };

  GPUVolume() : method(this->GetParam().make())
  {
    this->window->AddRenderer(this->renderer);
    this->window->SetSize(side, side);
    this->window->Render();
    this->window->MakeCurrent();
    const glm::dmat4 clip =
        glm::perspective(0.9, 1.0, 1e-5, 100.0) *
        glm::lookAt(glm::dvec3(5.0, 7.0, 11.0), glm::dvec3(0.0), glm::dvec3(0.0, 1.0, 0.0));
    this->view = makeView(clip, side, side);
    glGenTextures(1, &this->counts);
    glBindTexture(GL_TEXTURE_2D, this->counts);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, side, side, 0, GL_RED, GL_FLOAT, nullptr);
    glBindTexture(GL_TEXTURE_2D, 0);
    glGenFramebuffers(1, &this->framebuffer);
    glGenQueries(1, &this->query);
  }

  ~GPUVolume() override
  {
    this->window->MakeCurrent();
    this->method->release(false);
    this->drawables.release(false);
    glDeleteFramebuffers(1, &this->framebuffer);
    glDeleteTextures(1, &this->counts);
    glDeleteQueries(1, &this->query);
  }

  void setMesh(const TriangleSoup& soup)
  {
    this->geode = std::make_shared<SEDGeode>(std::make_shared<const SEDGeometry>(build(soup)));
  }

  const SEDGeometry& getGeometry() const { return this->geode->getGeometry(); }

  glm::dvec4 toModel(const glm::dvec4& lightWC) const
  {
    return *lightToModel({0, lightWC}, glm::dmat4(1.0), this->getGeometry().getOrigin());
  }

  /// What the CPU makes of the same light.
  std::vector<SilhouetteEdge> findOnCPU(const glm::dvec4& lightWC) const
  {
    const glm::dvec4 lightMC = this->toModel(lightWC);
    return BruteForceSilhouette().find(this->getGeometry(), computeFacing(this->getGeometry(), lightMC),
                                       chooseCasting(this->getGeometry(), lightMC));
  }

  Drawn draw(const glm::dvec4& lightWC, const CasterPlan& plan)
  {
    glBindFramebuffer(GL_FRAMEBUFFER, this->framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, this->counts, 0);
    const GLenum attachment = GL_COLOR_ATTACHMENT0;
    glDrawBuffers(1, &attachment);
    glViewport(0, 0, side, side);
    const float nothing[4] = {0.0f, 0.0f, 0.0f, 0.0f};
    glClearBufferfv(GL_COLOR, 0, nothing);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    this->drawVolume(lightWC, plan);
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);

    Drawn drawn;
    GLuint primitives = 0;
    glGetQueryObjectuiv(this->query, GL_QUERY_RESULT, &primitives);
    drawn.primitives = primitives;
    std::vector<float> pixels(static_cast<std::size_t>(side) * side);
    glReadPixels(0, 0, side, side, GL_RED, GL_FLOAT, pixels.data());
    drawn.unbalanced = static_cast<std::size_t>(
        std::count_if(pixels.begin(), pixels.end(), [&](float count) { return count != pixels[0]; }));
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return drawn;
  }

  /// A volume closed at both ends.
  static CasterPlan closedPlan(DarkCap darkCap)
  {
    CasterPlan plan;
    plan.count = StencilCount::ZPass; // counts what passes the depth test, which is everything
    plan.lightCap = true;
    plan.darkCap = darkCap;
    return plan;
  }

  /// Lights in the planes of some of the mesh's triangles, as far as rounding lets them be.
  std::vector<glm::dvec4> makeLightsInPlanes(std::mt19937& random) const
  {
    std::vector<glm::dvec4> lights;
    const SEDGeometry& geometry = this->getGeometry();
    for (int i = 0; i < 4; ++i)
    {
      const auto& corners = geometry.getTriangles()[random() % geometry.getTriangles().size()];
      const glm::dvec3 a(geometry.getPositions()[corners[0]]);
      const glm::dvec3 u = glm::dvec3(geometry.getPositions()[corners[1]]) - a;
      const glm::dvec3 v = glm::dvec3(geometry.getPositions()[corners[2]]) - a;
      lights.emplace_back(geometry.getOrigin() + a + 3.0 * u - 5.0 * v, 1.0);
      lights.emplace_back(u + 2.0 * v, 0.0);
    }
    return lights;
  }

private:
  void drawVolume(const glm::dvec4& lightWC, const CasterPlan& plan)
  {
    const std::vector<Light> lights = {{0, lightWC}};
    PathState state;
    state.lights[0].lightMC = this->toModel(lightWC);
    state.lights[0].faced = true;
    state.lights[0].plan = plan;
    const NodePath path;
    const GPUSilhouette::Surface surface = {this->geode.get(), &state, &path, glm::dmat4(1.0),
                                            FaceCulling::None};
    GPUSilhouette::Frame frame;
    frame.window = this->window;
    frame.lights = &lights;
    frame.view = &this->view;
    frame.drawables = &this->drawables;
    frame.clipFromWC = shadowClipFromWC(this->view, DepthRange());
    std::string error;
    ASSERT_TRUE(this->method->begin(frame, error)) << error;
    ASSERT_TRUE(this->method->prepare(surface, error)) << error;
    glBeginQuery(GL_PRIMITIVES_GENERATED, this->query);
    EXPECT_TRUE(this->method->drawVolume(surface, lights[0], plan.count));
    glEndQuery(GL_PRIMITIVES_GENERATED);
  }

  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkHeadlessRenderWindow> window;
  std::unique_ptr<GPUSilhouette> method;
  DrawableCache drawables;
  std::shared_ptr<SEDGeode> geode;
  View view;
  unsigned int framebuffer = 0;
  unsigned int counts = 0;
  unsigned int query = 0;
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
