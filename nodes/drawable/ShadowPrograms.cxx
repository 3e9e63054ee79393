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

// VTK writes the version line in place of the first line, so the switch has to follow that.
std::string withParallelSwitch(const char* source, bool parallel)
{
  std::string text = source;
  if (parallel)
  {
    text.insert(text.find('\n') + 1, "#define SHADOW_PARALLEL\n");
  }
  return text;
}

} // namespace

vtkShaderProgram* ShadowPrograms::use(Stage stage, bool parallel)
{
  static constexpr std::array<const char* const*, 4> vertexSources = {
      &shaders::extrude_vert, &shaders::extrude_vert, &shaders::screen_vert, &shaders::screen_vert};
  static constexpr std::array<const char* const*, 4> fragmentSources = {
      &shaders::prepass_frag, &shaders::volume_frag, &shaders::mask_frag, &shaders::resolve_frag};
  const std::string vertex = withParallelSwitch(*vertexSources[stage], parallel);
  const std::string fragment = withParallelSwitch(*fragmentSources[stage], parallel);
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
