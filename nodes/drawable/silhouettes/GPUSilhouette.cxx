#include "GPUSilhouette.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include "LightUniforms.h"
#include "OpenGL.h"
#include "ShadowVolume.h"

namespace shadow
{

bool GPUSilhouette::begin(const Frame& theFrame, std::string& /*error*/)
{
  this->frame = theFrame;
  this->programs.clear();
  return true;
}

bool GPUSilhouette::prepare(const Surface& surface, std::string& error)
{
  const std::shared_ptr<const SEDGeometry>& geometry = surface.geode->getSharedGeometry();
  const auto make = [&]
  {
    auto texels = std::make_unique<GeometryTexels>();
    if (!texels->upload(*geometry, error))
    {
      texels->release();
      texels.reset();
    }
    return texels;
  };
  const auto update = [&](GeometryTexels& texels) { texels.update(*geometry); };
  return this->tables.get(geometry, make, update) != nullptr;
}

bool GPUSilhouette::finishPreparing(std::string& /*error*/)
{
  return true;
}

GeometryTexels& GPUSilhouette::getTables(const Surface& surface)
{
  return this->tables.at(surface.geode->getGeometry());
}

void GPUSilhouette::bindFacing(vtkShaderProgram* program, const Surface& surface,
                               const std::vector<Light>& lights)
{
  this->bindCorners(static_cast<unsigned int>(program->GetHandle()), surface, lights);
}

void GPUSilhouette::bindCorners(unsigned int program, const Surface& surface,
                                const std::vector<Light>& lights)
{
  const SceneFrame& space = this->getTables(surface).getFrame();
  glUniform1f(glGetUniformLocation(program, "facingScale"), static_cast<float>(1.0 / space.unit));
  std::vector<Light> lightsMC;
  for (const Light& light : lights)
  {
    const auto state = surface.state->lights.find(light.index);
    if (state != surface.state->lights.end() && state->second.faced)
    {
      lightsMC.push_back({light.index, state->second.lightMC});
    }
  }
  setLightUniforms(program, lightsMC, space);
}

vtkShaderProgram* GPUSilhouette::useTables(ShadowPrograms::Stage stage, const Surface& surface,
                                           const std::string& switches, bool fromNear)
{
  vtkShaderProgram*& known = this->programs[{stage, fromNear, switches}];
  vtkShaderProgram* program =
      known != nullptr ? this->frame.window->GetShaderCache()->ReadyShaderProgram(known)
                       : ShadowPrograms(this->frame.window).use(stage, fromNear, switches);
  known = program;
  if (program != nullptr)
  {
    this->getTables(surface).bind(this->frame.window->GetState(),
                                  static_cast<unsigned int>(program->GetHandle()), tableUnit);
  }
  return program;
}

vtkShaderProgram* GPUSilhouette::use(ShadowPrograms::Stage stage, const Surface& surface,
                                     const std::vector<Light>& lights, const std::string& switches,
                                     bool fromNear)
{
  const View& view = *this->frame.view;
  vtkShaderProgram* program =
      this->useTables(stage, surface, this->getFacingSwitches() + switches, fromNear);
  if (program == nullptr)
  {
    return nullptr;
  }
  this->bindFacing(program, surface, lights);
  const glm::dmat4 wcFromMC = worldFromRelative(surface.geode->getGeometry(), surface.modelToWorld);
  setUniform(program, "clipFromMC", this->frame.clipFromWC * wcFromMC);
  if (view.parallel)
  {
    setUniform(program, "nearFromMC", view.viewDepth * wcFromMC);
  }
  setDepthBias(program, this->frame.reversedDepth, false);
  return program;
}

vtkShaderProgram* GPUSilhouette::useForVolume(ShadowPrograms::Stage stage, const Surface& surface,
                                              const Light& light, const std::string& switches)
{
  const PathLightState& state = surface.state->lights.at(light.index);
  const bool fromNear = startsAtNear(*this->frame.view, state.plan.count);
  vtkShaderProgram* program = this->use(stage, surface, {light}, switches, fromNear);
  if (program == nullptr)
  {
    return nullptr;
  }
  const SEDGeometry& geometry = surface.geode->getGeometry();
  setLight(program, state.lightMC, geometry.getReach());
  setUniform(program, "farPlaneMC",
             farPlaneToModel(state.plan.farPlaneWC, worldFromRelative(geometry, surface.modelToWorld)));
  program->SetUniformi("light", light.index);
  const bool lightFacingOnly = chooseCasting(geometry, state.lightMC) == Casting::LightFacing;
  program->SetUniformi("lightFacingOnly", lightFacingOnly ? 1 : 0);
  return program;
}

bool GPUSilhouette::isMirrored(const Surface& surface) const
{
  return this->frame.view->mirrored != (glm::determinant(glm::dmat3(surface.modelToWorld)) < 0.0);
}

FaceCounter GPUSilhouette::countWith(vtkShaderProgram* program, const Surface& surface,
                                     StencilCount count) const
{
  return {{this->frame.window->GetState(), program, CountBuffer::Color, this->frame.reversedDepth},
          count,
          this->isMirrored(surface)};
}

glm::vec3 GPUSilhouette::chooseApex(const SEDGeometry& geometry, const glm::dvec4& lightMC)
{
  const std::vector<glm::vec3>& positions = geometry.getPositions();
  const auto isApart = [&](const glm::vec3& position)
  { return lightMC.w == 0.0 || glm::dvec3(position) != glm::dvec3(lightMC); };
  // As Extruder::chooseApex() in nodes/geometry/volumes/ShadowVolume.cxx: from the middle of the list.
  const auto middle = positions.begin() + geometry.getTriangles()[geometry.getTriangles().size() / 2][0];
  const auto apart = isApart(*middle) ? middle : std::find_if(positions.begin(), positions.end(), isApart);
  return apart != positions.end() ? *apart : glm::vec3(0.0f);
}

bool GPUSilhouette::drawSurface(const Surface& surface)
{
  vtkShaderProgram* program = this->use(this->getSurfaceStage(), surface, *this->frame.lights, "", this->frame.view->parallel);
  if (program == nullptr)
  {
    return false;
  }
  GLuint others = ~0u;
  for (const Light& light : *this->frame.lights)
  {
    const auto state = surface.state->lights.find(light.index);
    const bool known = state != surface.state->lights.end() && state->second.faced;
    others &= known ? ~(1u << static_cast<unsigned>(light.index)) : ~0u;
  }
  glUniform1ui(glGetUniformLocation(static_cast<GLuint>(program->GetHandle()), "otherLights"), others);
  const SEDGeometry& geometry = surface.geode->getGeometry();
  program->SetUniformi("triangleCount", static_cast<int>(geometry.getTriangles().size()));
  this->frame.drawables->getGeometry(surface.geode->getSharedGeometry())
      .drawPrePass(this->frame.window->GetState(), program, nullptr, surface.faceCulling,
                   this->isMirrored(surface));
  return true;
}

bool GPUSilhouette::drawCap(const Surface& surface, const Light& light, StencilCount count, bool far)
{
  vtkShaderProgram* program = this->useForVolume(ShadowPrograms::SurfaceCap, surface, light);
  if (program == nullptr)
  {
    return false;
  }
  program->SetUniformi("farCap", far ? 1 : 0);
  const SEDGeometry& geometry = surface.geode->getGeometry();
  program->SetUniformi("triangleCount", static_cast<int>(geometry.getTriangles().size()));
  SEDGeometryDrawable& drawable = this->frame.drawables->getGeometry(surface.geode->getSharedGeometry());
  this->countWith(program, surface, count).count(1, false, [&] { drawable.draw(program, nullptr); });
  return true;
}

DarkCap GPUSilhouette::chooseDarkCap(const Light& light, const CasterPlan& plan)
{
  // The far copies of a directional light's volume at infinity are one point.
  const bool farEndOpen = light.positionWC.w != 0.0 || !plan.isFarAtInfinity();
  return farEndOpen ? plan.darkCap : DarkCap::None;
}

bool GPUSilhouette::drawVolume(const Surface& surface, const Light& light, StencilCount count)
{
  const PathLightState& state = surface.state->lights.at(light.index);
  const DarkCap darkCap = chooseDarkCap(light, state.plan);
  bool drawn = this->drawSides(surface, light, count, darkCap == DarkCap::Fan);
  if (state.plan.lightCap)
  {
    drawn = drawn && this->drawCap(surface, light, count, false);
  }
  if (darkCap == DarkCap::Triangles)
  {
    drawn = drawn && this->drawCap(surface, light, count, true);
  }
  return drawn;
}

void GPUSilhouette::unbind()
{
  for (int unit = tableUnit; unit < tableUnit + unitCount; ++unit)
  {
    this->frame.window->GetState()->vtkglActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
  }
}

void GPUSilhouette::sweep()
{
  this->tables.sweep();
}

void GPUSilhouette::release(bool contextLost)
{
  this->tables.release(contextLost);
}

std::size_t GPUSilhouette::getMemorySize() const
{
  return this->tables.getMemorySize();
}

} // namespace shadow
