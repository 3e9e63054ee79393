#include "Capabilities.h"

#include <algorithm>
#include <cstring>
#include <string>

#include "OpenGL.h"

namespace shadow
{

namespace
{

bool hasExtension(const char* name)
{
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i)
  {
    if (std::strcmp(reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i))),
                    name) == 0)
    {
      return true;
    }
  }
  return false;
}

} // namespace

Capabilities queryCapabilities()
{
  Capabilities capabilities;
  GLint major = 0;
  GLint minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  const int version = 10 * major + minor;
  capabilities.version = std::to_string(major) + "." + std::to_string(minor);
  if (version < 32)
  {
    capabilities.missing = "shadow volumes need OpenGL 3.2, this context has " + capabilities.version;
    return capabilities;
  }
  capabilities.usable = true;
  capabilities.clipControl =
      (version >= 45 || hasExtension("GL_ARB_clip_control")) && glClipControl != nullptr;
  capabilities.sampleShading = version >= 40 || hasExtension("GL_ARB_sample_shading");
  capabilities.sampleCoverage = version >= 40 || hasExtension("GL_ARB_gpu_shader5");
  capabilities.compute = version >= 43 && glDispatchCompute != nullptr;
  const GLubyte* name = glGetString(GL_RENDERER);
  const std::string renderer = name != nullptr ? reinterpret_cast<const char*>(name) : "";
  for (const char* software : {"llvmpipe", "softpipe", "SWR", "Software Rasterizer"})
  {
    capabilities.software = capabilities.software || renderer.find(software) != std::string::npos;
  }
  GLint integerSamples = 1;
  GLint depthSamples = 1;
  GLint colorSamples = 1;
  glGetIntegerv(GL_MAX_INTEGER_SAMPLES, &integerSamples);
  glGetIntegerv(GL_MAX_DEPTH_TEXTURE_SAMPLES, &depthSamples);
  glGetIntegerv(GL_MAX_COLOR_TEXTURE_SAMPLES, &colorSamples);
  capabilities.maximumSamples = std::max(1, std::min({integerSamples, depthSamples, colorSamples}));
  return capabilities;
}

std::string findMissing(const Capabilities& capabilities, SilhouetteMethod method, int samples)
{
  if (method == SilhouetteMethod::Compute && !capabilities.compute)
  {
    return "needs OpenGL 4.3, this context has " + capabilities.version;
  }
  const bool countsInColor = isOnGPU(method) && method != SilhouetteMethod::FacingTexture;
  if (countsInColor && samples > 1 && !capabilities.sampleShading)
  {
    return "needs OpenGL 4.0 or GL_ARB_sample_shading for more than one sample a pixel, this context has " +
           capabilities.version;
  }
  return "";
}

SilhouetteMethod nextBest(SilhouetteMethod method)
{
  switch (method)
  {
  case SilhouetteMethod::FacingTexture:
    return SilhouetteMethod::BruteForce;
  case SilhouetteMethod::FacingTextureResident:
    return SilhouetteMethod::FacingTexture;
  default:
    return SilhouetteMethod::FacingTextureResident;
  }
}

} // namespace shadow
