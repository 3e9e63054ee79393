#include "SilhouetteCamera.h"

#include <algorithm>
#include <optional>

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include "GLStateScope.h"
#include "LightUniforms.h"
#include "OpenGL.h"
#include "SEDGeode.h"
#include "ShadowPrograms.h"
#include "ShadowVolume.h"
#include "TriangleDrawable.h"

namespace shadow
{

namespace
{

/// One point, one texel, nothing but colour.
void setState(vtkOpenGLState* state)
{
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_STENCIL_TEST);
  state->vtkglDisable(GL_BLEND);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDisable(GL_COLOR_LOGIC_OP);
}

/// Points of one pixel while it stands. Behind vtkOpenGLState, which so never learns of the change.
class PointSizeScope
{
public:
  PointSizeScope()
  {
    glGetFloatv(GL_POINT_SIZE, &this->previous);
    glPointSize(1.0f);
  }
  ~PointSizeScope() { glPointSize(this->previous); }
  PointSizeScope(const PointSizeScope&) = delete;
  PointSizeScope& operator=(const PointSizeScope&) = delete;

private:
  float previous = 1.0f;
};

} // namespace

vtkOpenGLState* SilhouetteCamera::getState(vtkOpenGLRenderWindow* window)
{
  return window->GetState();
}

bool SilhouetteCamera::draw(vtkOpenGLRenderWindow* window, TriangleDrawable& triangles,
                            const std::vector<Light>& lights, std::string& error)
{
  if (!this->texels.allocate(triangles.getSize(), error))
  {
    return false;
  }
  if (this->framebuffer == 0)
  {
    glGenFramebuffers(1, &this->framebuffer);
  }
  // The clip volume does not matter here, and is not changed.
  const GLStateScope scope(window->GetState(), false);
  const PointSizeScope pointSize;
  window->GetState()->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->framebuffer);
  const bool drawn = this->drawLayers(window, triangles, lights, error);
  glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, 0, 0, 0);
  return drawn;
}

bool SilhouetteCamera::drawLayers(vtkOpenGLRenderWindow* window, TriangleDrawable& triangles,
                                  const std::vector<Light>& lights, std::string& error)
{
  vtkShaderProgram* program = ShadowPrograms(window).use(ShadowPrograms::Facing, false);
  if (program == nullptr)
  {
    error = "the shader of the silhouette camera does not compile";
    return false;
  }
  setLightUniforms(program, lights, triangles.getFrame());
  const int layerSize[2] = {this->texels.getWidth(), this->texels.getHeight()};
  program->SetUniform2i("layerSize", layerSize);
  vtkOpenGLState* state = window->GetState();
  setState(state);
  state->vtkglViewport(0, 0, layerSize[0], layerSize[1]);
  for (int layer = 0; layer < this->texels.getLayers(); ++layer)
  {
    this->texels.attachLayer(GL_FRAMEBUFFER, layer);
    const GLenum buffer = GL_COLOR_ATTACHMENT0;
    glDrawBuffers(1, &buffer);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    {
      error = "the GL cannot draw into a texture of two 32-bit integers";
      return false;
    }
    triangles.draw(program, this->texels.getFirstOfLayer(layer), this->texels.getCountOfLayer(layer));
  }
  return true;
}

void SilhouetteCamera::getFacing(const VETRange& range, const Light& light, LightFacing& facing) const
{
  const std::size_t triangles = range.countTriangles();
  const auto bit = static_cast<unsigned>(light.index);
  facing.towards.assign(triangles);
  facing.away.assign(triangles);
  const std::uint32_t* texel = this->words.data() + 2 * std::size_t{range.firstTriangle};
  for (std::size_t first = 0; first < triangles; first += 64)
  {
    const std::size_t count = std::min<std::size_t>(64, triangles - first);
    std::uint64_t towards = 0;
    std::uint64_t away = 0;
    for (std::size_t place = 0; place < count; ++place, texel += 2)
    {
      towards |= std::uint64_t{(texel[0] >> bit) & 1u} << place;
      away |= std::uint64_t{(texel[1] >> bit) & 1u} << place;
    }
    facing.towards.data()[first >> 6] = towards;
    facing.away.data()[first >> 6] = away;
  }
  const std::optional<glm::dvec4> lightMC =
      lightToModel(light, range.modelToWorld, range.geometry->getOrigin());
  if (lightMC)
  {
    clearTouching(*range.geometry, *lightMC, facing);
  }
}

void SilhouetteCamera::release(bool contextLost)
{
  this->texels.release(contextLost);
  this->readBack.release(contextLost);
  if (!contextLost && this->framebuffer != 0)
  {
    glDeleteFramebuffers(1, &this->framebuffer);
  }
  this->framebuffer = 0;
  this->words.clear();
}

std::size_t SilhouetteCamera::getMemorySize() const
{
  return this->texels.getMemorySize() + this->readBack.getMemorySize();
}

} // namespace shadow
