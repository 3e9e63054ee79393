#include "LightingHook.h"

#include <algorithm>
#include <array>

#include <glm/gtc/matrix_access.hpp>

#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>
#include <vtkTextureUnitManager.h>

#include "OpenGL.h"
#include "Shaders.h"

namespace shadow
{

namespace
{

int replaceAll(std::string& text, const std::string& from, const std::string& to)
{
  int replaced = 0;
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
  {
    text.replace(at, from.size(), to);
    ++replaced;
  }
  return replaced;
}

// The lines of VTK's Blinn-Phong lighting; unchanged from VTK 9.1 to 9.7.
int substituteBlinnPhong(std::string& shader, const std::string& light)
{
  const std::string factor = " * shadowFactorOfPass(" + light + ") * lightColor" + light + ");";
  return replaceAll(shader, "diffuse += (df * lightColor" + light + ");", "diffuse += (df" + factor) +
         replaceAll(shader, "specular += (sf * lightColor" + light + ");", "specular += (sf" + factor);
}

// The lines of its physically based lighting: directional lights only, and with attenuation.
int substitutePhysicallyBased(std::string& shader, const std::string& light)
{
  const std::string factor = "radiance = shadowFactor(" + light + ") * lightColor" + light;
  return replaceAll(shader, "radiance = lightColor" + light + ";", factor + ";") +
         replaceAll(shader, "radiance = lightColor" + light + " * attenuation;", factor + " * attenuation;");
}

// Lights that are not the headlight are declared, and the first one's colour is used, not only declared.
bool usesSceneLights(const std::string& shader)
{
  const std::string colour = "lightColor0";
  const std::size_t declared = shader.find("uniform vec3 " + colour);
  return shader.find("uniform vec3 lightDirectionVC0") != std::string::npos &&
         declared != std::string::npos &&
         shader.find(colour, shader.find(';', declared)) != std::string::npos;
}

} // namespace

bool LightingHook::substitute(std::string& fragmentShader, bool mirrored) const
{
  // VTK calls once for each time that the pass is among a prop's render passes: twice for an actor that is
  // shown by itself and in an assembly.
  if (fragmentShader.find("readShadowMask") != std::string::npos)
  {
    return true;
  }
  int blinnPhong = 0;
  int physicallyBased = 0;
  const std::size_t lights = std::min<std::size_t>(this->strength.size(), maximumLights);
  for (std::size_t i = 0; i < lights; ++i)
  {
    blinnPhong += substituteBlinnPhong(fragmentShader, std::to_string(i));
    physicallyBased += substitutePhysicallyBased(fragmentShader, std::to_string(i));
  }
  if (blinnPhong > 0)
  {
    // Lights beyond the last with a shadow belong to the ambient pass.
    for (std::size_t i = lights; i < this->strength.size(); ++i)
    {
      const std::string colour = "lightColor" + std::to_string(i) + ");";
      replaceAll(fragmentShader, "(df * " + colour, "(df * (shadowPass < 0 ? 1.0 : 0.0) * " + colour);
      replaceAll(fragmentShader, "(sf * " + colour, "(sf * (shadowPass < 0 ? 1.0 : 0.0) * " + colour);
    }
    replaceAll(fragmentShader, "vec4(ambientColor + diffuse + specular, opacity)",
               "vec4((shadowPass < 0 ? ambientColor : vec3(0.0)) + diffuse + specular, opacity)");
  }
  // A shader that is not a sum over lights is drawn in the ambient pass and adds nothing in the lighting
  // passes. Alpha tells there that the surface shows.
  const std::size_t end = fragmentShader.rfind('}');
  if (end != std::string::npos)
  {
    const std::string light = blinnPhong > 0 ? "gl_FragData[0].rgb" : "vec3(0.0)";
    fragmentShader.insert(end, "  if (shadowPass >= 0) { gl_FragData[0] = vec4(" + light + ", 1.0); }\n");
  }
  const std::size_t main = fragmentShader.find("void main()");
  if (main != std::string::npos)
  {
    fragmentShader.insert(fragmentShader.find('{', main) + 1, "\n  readShadowMask();\n");
    // VTK writes the version in place of this line; what is not VTK's may not have it.
    const std::string first = "//VTK::System::Dec\n";
    const bool coverage = this->knowsCoverage && this->samples > 1 && fragmentShader.find(first) == 0;
    fragmentShader.insert(main, "#define SHADOW_SAMPLES " + std::to_string(this->samples) +
                                    "\n#define SHADOW_MATCH " + (mirrored ? "0" : "1") +
                                    "\n#define SHADOW_COVERAGE " + (coverage ? "1\n" : "0\n") +
                                    shaders::shadowFactor_glsl + "\n");
    if (coverage)
    {
      fragmentShader.insert(first.size(), "#extension GL_ARB_gpu_shader5 : enable\n");
    }
  }
  return blinnPhong + physicallyBased > 0 || !usesSceneLights(fragmentShader);
}

void LightingHook::begin(vtkOpenGLState* state, ShadowVolumeEffect& effect, const View& view)
{
  ShadowTarget& target = effect.getTarget();
  this->textureTarget = target.getTextureTarget();
  this->samplePlaces = &target.getSamplePlaces();
  this->boundMask = this->bind(state, target.getMaskTexture());
  this->boundDepth = this->bind(state, target.getDepthTexture());

  const DepthRange& depth = effect.getDepthRange();
  this->reversed = depth.reversed;
  if (view.parallel)
  {
    // VTK's depth is linear from the near plane; this is the distance that it covers.
    const glm::dvec4 rowZ = glm::row(view.clipFromWC, 2);
    const glm::dvec4 rowW = glm::row(view.clipFromWC, 3);
    const double covered = 2.0 * rowW.w / glm::length(glm::dvec3(rowZ));
    this->range[0] = static_cast<float>(depth.farthest);
    this->range[1] = static_cast<float>(depth.nearest - depth.farthest);
    this->range[2] = 0.0f;
    this->range[3] = static_cast<float>(covered);
  }
  else
  {
    this->range[0] = static_cast<float>(view.nearW);
    this->range[1] = this->range[2] = this->range[3] = 0.0f;
  }
}

LightingHook::BoundTexture LightingHook::bind(vtkOpenGLState* state, unsigned int texture) const
{
  BoundTexture bound;
  bound.unit = state->GetTextureUnitManager()->Allocate();
  state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(bound.unit));
  const bool single = this->textureTarget == GL_TEXTURE_2D;
  glGetIntegerv(single ? GL_TEXTURE_BINDING_2D : GL_TEXTURE_BINDING_2D_MULTISAMPLE, &bound.before);
  glBindTexture(this->textureTarget, texture);
  return bound;
}

void LightingHook::end(vtkOpenGLState* state)
{
  for (BoundTexture* bound : {&this->boundMask, &this->boundDepth})
  {
    if (bound->unit >= 0)
    {
      state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(bound->unit));
      glBindTexture(this->textureTarget, static_cast<GLuint>(bound->before));
      state->GetTextureUnitManager()->Free(bound->unit);
      *bound = {};
    }
  }
}

void LightingHook::setUniforms(vtkOpenGLState* state, vtkShaderProgram* program) const
{
  if (program->IsUniformUsed("shadowPass"))
  {
    program->SetUniformi("shadowPass", this->pass);
  }
  if (!program->IsUniformUsed("shadowMask"))
  {
    return;
  }
  std::array<float, maximumLights> values{};
  std::copy_n(this->strength.begin(), std::min<std::size_t>(this->strength.size(), maximumLights),
              values.begin());
  program->SetUniform1fv("shadowStrength", maximumLights, values.data());
  program->SetUniformi("shadowMask", this->boundMask.unit);
  // That of the moment: ambient occlusion draws into a framebuffer of its own, where the view begins at 0, 0.
  int viewport[4] = {0, 0, 0, 0};
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  program->SetUniform2i("shadowOrigin", viewport);
  if (program->IsUniformUsed("shadowEverySample"))
  {
    GLint drawn = 0;
    glGetIntegerv(GL_SAMPLES, &drawn);
    program->SetUniformi("shadowEverySample", drawn == this->samples ? 0 : -1);
  }
  if (program->IsUniformUsed("shadowDepth"))
  {
    program->SetUniformi("shadowDepth", this->boundDepth.unit);
    program->SetUniform4f("shadowRange", this->range);
    program->SetUniformi("shadowReversed", this->reversed ? 1 : 0);
    const int places = static_cast<int>(this->samplePlaces->size() / 2);
    program->SetUniform2fv("shadowSamplePlace", places,
                           reinterpret_cast<const float(*)[2]>(this->samplePlaces->data()));
  }
}

} // namespace shadow
