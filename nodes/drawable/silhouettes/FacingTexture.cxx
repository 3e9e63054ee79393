#include "FacingTexture.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include "OpenGL.h"

namespace shadow
{

bool FacingTexture::begin(const Frame& theFrame, std::string& error)
{
  if (!this->EdgeQuadSilhouette::begin(theFrame, error))
  {
    return false;
  }
  this->drawnNow = !theFrame.unchanged || this->camera.getTexels().getTexture() == 0;
  if (!this->drawnNow)
  {
    return true;
  }
  this->triangles.upload(*theFrame.collection);
  return this->triangles.getSize() == 0 ||
         this->camera.draw(theFrame.window, this->triangles, *theFrame.lights, error);
}

void FacingTexture::bindFacing(vtkShaderProgram* program, const Surface& surface,
                               const std::vector<Light>& /*lights*/)
{
  this->camera.getTexels().bind(this->getFrame().window->GetState(),
                                static_cast<unsigned int>(program->GetHandle()), facingUnit, "facingTexels",
                                "facingLayer");
  const VETRange* range = this->getFrame().collection->find(*surface.path);
  // Not through VTK, which remembers values from 9.7 on: other methods set it for programs of both kinds.
  glUniform1i(glGetUniformLocation(static_cast<GLuint>(program->GetHandle()), "firstTriangle"),
              range != nullptr ? static_cast<GLint>(range->firstTriangle) : 0);
}

void FacingTexture::getFacing(const NodePath& path, const Light& light, LightFacing& facing) const
{
  if (const VETRange* range = this->getFrame().collection->find(path))
  {
    this->camera.getFacing(*range, light, facing);
  }
}

void FacingTexture::release(bool contextLost)
{
  this->triangles.release(contextLost);
  this->camera.release(contextLost);
  this->EdgeQuadSilhouette::release(contextLost);
}

std::size_t FacingTexture::getMemorySize() const
{
  return this->triangles.getMemorySize() + this->camera.getMemorySize() +
         this->EdgeQuadSilhouette::getMemorySize();
}

} // namespace shadow
