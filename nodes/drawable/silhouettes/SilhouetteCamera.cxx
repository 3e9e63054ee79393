#include "SilhouetteCamera.h"

#include <algorithm>

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
  // The clip volume does not matter here, and is not changed.
  const GLStateScope scope(window->GetState(), false);
  vtkShaderProgram* program = ShadowPrograms(window).use(ShadowPrograms::Facing, false);
  if (program == nullptr)
  {
    error = "the shader of the silhouette camera does not compile";
    return false;
  }
  setLightUniforms(program, lights, triangles.getFrame());
  return this->painter.paint(
      window->GetState(), this->texels, program,
      [&](std::size_t first, std::size_t count) { triangles.draw(program, first, count); }, error);
}

void SilhouetteCamera::getFacing(const VETRange& range, const Light& light, LightFacing& facing) const
{
  const std::size_t triangles = range.countTriangles();
  const auto bit = static_cast<unsigned>(light.index);
  facing.towards.assign(triangles);
  facing.away.assign(triangles);
  facing.mixedWords.reset();
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
}

void SilhouetteCamera::release(bool contextLost)
{
  this->texels.release(contextLost);
  this->readBack.release(contextLost);
  this->painter.release(contextLost);
  this->words.clear();
}

std::size_t SilhouetteCamera::getMemorySize() const
{
  return this->texels.getMemorySize() + this->readBack.getMemorySize();
}

} // namespace shadow
