#include "ShadowPrograms.h"

#include <array>

#include <glm/gtc/type_ptr.hpp>

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkShaderProgram.h>

#include "Shaders.h"

namespace shadow
{

namespace
{

// VTK writes the version line in place of the first line, so the switches have to follow that.
std::string withSwitches(const char* source, const std::string& switches)
{
  std::string text = source;
  text.insert(text.find('\n') + 1, switches);
  return text;
}

} // namespace

vtkShaderProgram* ShadowPrograms::use(Stage stage, bool parallel)
{
  static constexpr std::array<const char* const*, 4> vertexSources = {
      &shaders::extrude_vert, &shaders::extrude_vert, &shaders::screen_vert, &shaders::screen_vert};
  static constexpr std::array<const char* const*, 4> fragmentSources = {
      &shaders::prepass_frag, &shaders::volume_frag, &shaders::mask_frag, &shaders::resolve_frag};
  std::string switches = parallel ? "#define SHADOW_PARALLEL\n" : "";
  switches += stage == PrePass ? "#define SHADOW_PREPASS\n" : "";
  const std::string vertex = withSwitches(*vertexSources[stage], switches);
  const std::string fragment = withSwitches(*fragmentSources[stage], switches);
  return this->window->GetShaderCache()->ReadyShaderProgram(vertex.c_str(), fragment.c_str(), "");
}

void setUniform(vtkShaderProgram* program, const char* name, const glm::dmat4& matrix)
{
  glm::mat4 values(matrix);
  program->SetUniformMatrix4x4(name, glm::value_ptr(values));
}

void setUniform(vtkShaderProgram* program, const char* name, const glm::dvec4& vector)
{
  const glm::vec4 values(vector);
  program->SetUniform4f(name, glm::value_ptr(values));
}

} // namespace shadow
