#include "ShadowPrograms.h"

#include <array>
#include <limits>

#include <glm/gtc/type_ptr.hpp>

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkShaderProgram.h>

#include "SceneFrame.h"
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

vtkShaderProgram* ShadowPrograms::use(Stage stage, bool fromNear, const std::string& switches)
{
  struct Sources
  {
    const char* vertex;
    const char* fragment;
    const char* switches;
    const char* geometry = "";
  };
  static const std::array<Sources, 24> stages = {
      Sources{shaders::extrude_vert, shaders::prepass_frag, "#define SHADOW_PREPASS\n"},
      Sources{shaders::extrude_vert, shaders::volume_frag, ""},
      Sources{shaders::extrude_vert, shaders::volume_frag, "#define SHADOW_COUNT_IN_COLOR\n"},
      Sources{shaders::extrude_vert, shaders::volume_frag,
              "#define SHADOW_COUNT_IN_COLOR\n#define SHADOW_HANDED_ON\n", shaders::volumeHandedOn_geom},
      Sources{shaders::screen_vert, shaders::mask_frag, ""},
      Sources{shaders::screen_vert, shaders::mask_frag, "#define SHADOW_COUNT_IN_COLOR\n"},
      Sources{shaders::screen_vert, shaders::mask_frag,
              "#extension GL_ARB_sample_shading : require\n"
              "#define SHADOW_COUNT_IN_COLOR\n#define SHADOW_MULTISAMPLE\n"},
      Sources{shaders::screen_vert, shaders::kept_frag, ""},
      Sources{shaders::screen_vert, shaders::kept_frag,
              "#extension GL_ARB_sample_shading : require\n#define SHADOW_MULTISAMPLE\n"},
      Sources{shaders::screen_vert, shaders::back_frag, ""},
      Sources{shaders::screen_vert, shaders::resolve_frag, ""},
      Sources{shaders::screen_vert, shaders::light_frag, ""},
      Sources{shaders::facing_vert, shaders::facing_frag, ""},
      Sources{shaders::surface_vert, shaders::prepass_frag, ""},
      Sources{shaders::surface_vert, shaders::volume_frag,
              "#define SHADOW_CAP\n#define SHADOW_COUNT_IN_COLOR\n#define SHADOW_MULTIPLICITY\n"},
      Sources{shaders::sides_vert, shaders::volume_frag,
              "#define SHADOW_COUNT_IN_COLOR\n#define SHADOW_MULTIPLICITY\n"},
      Sources{shaders::surface_vert, shaders::prepass_frag, "#define SHADOW_HANDED_ON\n",
              shaders::surface_geom},
      Sources{shaders::adjacency_vert, shaders::volume_frag,
              "#define SHADOW_COUNT_IN_COLOR\n#define SHADOW_MULTIPLICITY\n", shaders::volume_geom},
      Sources{shaders::triangleFacing_vert, shaders::texel_frag, ""},
      Sources{shaders::edgeStates_vert, shaders::texel_frag, ""},
      Sources{shaders::extrude_vert, shaders::outlineDepth_frag, ""},
      Sources{shaders::outlineEdge_vert, shaders::outlineEdge_frag, ""},
      Sources{shaders::outlineFace_vert, shaders::outlineFace_frag, ""},
      Sources{shaders::screen_vert, shaders::outlineBlend_frag, ""}};
  const Sources& sources = stages[stage];
  const std::string all =
      sources.switches + std::string(fromNear ? "#define SHADOW_PARALLEL\n" : "") + switches;
  const std::string vertex = withSwitches(sources.vertex, all);
  const std::string fragment = withSwitches(sources.fragment, all);
  const std::string geometry = *sources.geometry != '\0' ? withSwitches(sources.geometry, all) : "";
  return this->window->GetShaderCache()->ReadyShaderProgram(vertex.c_str(), fragment.c_str(),
                                                            geometry.c_str());
}

glm::vec2 depthBias(bool reversedDepth, bool asSides)
{
  // With reversed depth the same number of units everywhere: four in the last place. With ordinary depth,
  // which is close to 1 for all that is not close to the near plane, often less than one: see the header. A
  // power of two: w - w * rounding + w * rounding is w again, whatever is rounded on the way, while
  // with 1.2e-7 one far end in 150 came to lie beyond the far plane.
  const float rounding = asSides ? 2.0f * std::numeric_limits<float>::epsilon() : 0.0f;
  return {1.0f - rounding, reversedDepth ? 0.0f : rounding};
}

void setDepthBias(vtkShaderProgram* program, bool reversedDepth, bool asSides, const char* uniform)
{
  const glm::vec2 bias = depthBias(reversedDepth, asSides);
  program->SetUniform2f(uniform, glm::value_ptr(bias));
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

LightValues makeLightValues(const glm::dvec4& lightMC, double reach)
{
  const SplitVector parts = split(glm::dvec3(lightMC));
  return {glm::vec4(parts.high, lightMC.w), parts.low, static_cast<float>(0.125 * reach)};
}

void setLight(vtkShaderProgram* program, const glm::dvec4& lightMC, double reach)
{
  const LightValues values = makeLightValues(lightMC, reach);
  program->SetUniform4f("lightMC", glm::value_ptr(values.lightMC));
  program->SetUniform3f("lightLowMC", glm::value_ptr(values.lightLowMC));
  program->SetUniformf("rayLength", values.rayLength);
}

} // namespace shadow
