#include "GpuScene.h"

#include <algorithm>
#include <cmath>

#include <vtkOpenGLState.h>

#include "OpenGL.h"
#include "ShadowVolume.h"

namespace shadow::test
{

GpuWindow::GpuWindow()
{
  this->window->SetSize(64, 48);
  this->window->AddRenderer(this->renderer);
  this->window->Render();
}

GpuWindow::~GpuWindow() = default;

vtkOpenGLState* GpuWindow::getState()
{
  return this->window->GetState();
}

GpuScene::~GpuScene()
{
  this->camera.release();
  this->triangles.release();
}

std::shared_ptr<Transform> GpuScene::add(const std::shared_ptr<const SEDGeometry>& geometry,
                                         const glm::dmat4& matrix)
{
  auto transform = std::make_shared<Transform>();
  transform->matrix = matrix;
  transform->addChild(std::make_shared<SEDGeode>(geometry));
  this->root.addChild(transform);
  return transform;
}

std::shared_ptr<Transform> GpuScene::add(const TriangleSoup& soup, const glm::dmat4& matrix)
{
  return this->add(std::make_shared<const SEDGeometry>(build(soup)), matrix);
}

std::string GpuScene::draw(const std::vector<Light>& lights)
{
  std::string error;
  this->collector.collect(this->root);
  this->triangles.upload(this->collector.getCollection());
  if (!this->camera.draw(this->window, this->triangles, lights, error))
  {
    return error.empty() ? "no reason given" : error;
  }
  this->camera.startReadBack(this->window);
  return this->camera.fetch() ? "" : "nothing fetched";
}

bool hasExactArithmetic()
{
  GLint major = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  bool exact = major >= 4;
  GLint extensions = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &extensions);
  for (GLint i = 0; i < extensions && !exact; ++i)
  {
    const GLubyte* name = glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
    exact = std::string(reinterpret_cast<const char*>(name)) == "GL_ARB_gpu_shader5";
  }
  return exact;
}

int facingOf(const LightFacing& facing, std::size_t triangle)
{
  return static_cast<int>(facing.towards.test(triangle)) - static_cast<int>(facing.away.test(triangle));
}

void FacingComparison::add(const FacingComparison& other)
{
  this->triangles += other.triangles;
  this->different += other.different;
  this->largestDistance = std::max(this->largestDistance, other.largestDistance);
}

FacingComparison compareFacing(const SilhouetteCamera& camera, const VETRange& range, const Light& light)
{
  const SEDGeometry& geometry = *range.geometry;
  const glm::dvec4 lightMC = *lightToModel(light, range.modelToWorld, geometry.getOrigin());
  const LightFacing exact = computeFacing(geometry, lightMC);
  LightFacing drawn;
  camera.getFacing(range, light, drawn);
  FacingComparison result;
  result.triangles = geometry.getTriangles().size();
  for (std::size_t t = 0; t < result.triangles; ++t)
  {
    if (drawn.towards.test(t) && drawn.away.test(t))
    {
      result.largestDistance = HUGE_VAL;
    }
    if (facingOf(exact, t) != facingOf(drawn, t))
    {
      const auto& corners = geometry.getTriangles()[t];
      const glm::dvec3 a(geometry.getPositions()[corners[0]]);
      const glm::dvec3 u = glm::dvec3(geometry.getPositions()[corners[1]]) - a;
      const glm::dvec3 v = glm::dvec3(geometry.getPositions()[corners[2]]) - a;
      const glm::dvec3 arm = glm::dvec3(lightMC) - lightMC.w * a;
      const glm::dvec3 normal = glm::cross(u, v);
      const double lengths = glm::length(normal) * glm::length(arm);
      ++result.different;
      result.largestDistance =
          std::max(result.largestDistance, lengths > 0.0 ? std::abs(glm::dot(normal, arm)) / lengths : 0.0);
    }
  }
  return result;
}

} // namespace shadow::test
