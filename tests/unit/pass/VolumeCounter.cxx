#include "VolumeCounter.h"

#include <algorithm>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "BruteForceSilhouette.h"
#include "OpenGL.h"

namespace shadow::test
{

namespace
{

constexpr int side = 160; ///< pixels

} // namespace

VolumeCounter::VolumeCounter(std::unique_ptr<GPUSilhouette> silhouette) : method(std::move(silhouette))
{
  this->window->AddRenderer(this->renderer);
  this->window->SetSize(side, side);
  this->window->Render();
  this->window->MakeCurrent();
  const glm::dmat4 clip = glm::perspective(0.9, 1.0, 1e-5, 100.0) *
                          glm::lookAt(glm::dvec3(5.0, 7.0, 11.0), glm::dvec3(0.0), glm::dvec3(0.0, 1.0, 0.0));
  this->view = makeView(clip, side, side);
  glGenTextures(1, &this->counts);
  glBindTexture(GL_TEXTURE_2D, this->counts);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, side, side, 0, GL_RED, GL_FLOAT, nullptr);
  glBindTexture(GL_TEXTURE_2D, 0);
  glGenFramebuffers(1, &this->framebuffer);
  glGenQueries(1, &this->query);
}

VolumeCounter::~VolumeCounter()
{
  this->window->MakeCurrent();
  this->method->release(false);
  this->drawables.release(false);
  glDeleteFramebuffers(1, &this->framebuffer);
  glDeleteTextures(1, &this->counts);
  glDeleteQueries(1, &this->query);
}

void VolumeCounter::setMesh(const TriangleSoup& soup)
{
  this->geode = std::make_shared<SEDGeode>(std::make_shared<const SEDGeometry>(build(soup)));
}

glm::dvec4 VolumeCounter::toModel(const glm::dvec4& lightWC) const
{
  return *lightToModel({0, lightWC}, glm::dmat4(1.0), this->getGeometry().getOrigin());
}

std::vector<SilhouetteEdge> VolumeCounter::findOnCPU(const glm::dvec4& lightWC) const
{
  const glm::dvec4 lightMC = this->toModel(lightWC);
  return BruteForceSilhouette().find(this->getGeometry(), computeFacing(this->getGeometry(), lightMC),
                                     chooseCasting(this->getGeometry(), lightMC));
}

VolumeCounter::Drawn VolumeCounter::draw(const glm::dvec4& lightWC, const CasterPlan& plan)
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

void VolumeCounter::drawVolume(const glm::dvec4& lightWC, const CasterPlan& plan)
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

CasterPlan VolumeCounter::closedPlan(DarkCap darkCap)
{
  CasterPlan plan;
  plan.count = StencilCount::ZPass; // counts what passes the depth test, which is everything
  plan.lightCap = true;
  plan.darkCap = darkCap;
  return plan;
}

std::vector<glm::dvec4> VolumeCounter::makeLightsInPlanes(std::mt19937& random) const
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

} // namespace shadow::test
