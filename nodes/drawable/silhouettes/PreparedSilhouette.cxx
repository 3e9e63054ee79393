#include "PreparedSilhouette.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include "OpenGL.h"
#include "SweepUnused.h"

namespace shadow
{

void PreparedSilhouette::Prepared::release(bool contextLost)
{
  this->facing.release(contextLost);
  this->edges.release(contextLost);
}

std::size_t PreparedSilhouette::Prepared::getMemorySize() const
{
  return this->facing.getMemorySize() + this->edges.getMemorySize();
}

bool PreparedSilhouette::prepare(const Surface& surface, std::string& error)
{
  if (!this->EdgeQuadSilhouette::prepare(surface, error))
  {
    return false;
  }
  const auto entry = this->paths.try_emplace(*surface.path).first;
  entry->second.used = true;
  if (entry->second.prepared == nullptr)
  {
    entry->second.prepared = this->makePrepared();
  }
  Prepared& prepared = *entry->second.prepared;
  std::vector<std::pair<int, glm::dvec4>> lights;
  for (const auto& [index, light] : surface.state->lights)
  {
    if (light.faced)
    {
      lights.emplace_back(index, light.lightMC);
    }
  }
  if (prepared.geometry.lock() == surface.geode->getSharedGeometry() && prepared.lights == lights)
  {
    return true;
  }
  prepared.lights = std::move(lights);
  prepared.geometry.reset(); // until it is found
  Surface kept = surface;
  kept.path = &entry->first; // the visitor's own changes as it walks on
  this->changes.push_back({kept, &prepared});
  return true;
}

bool PreparedSilhouette::finishPreparing(std::string& error)
{
  const bool found = this->changes.empty() || this->find(this->changes, error);
  for (const Change& change : this->changes)
  {
    change.prepared->geometry.reset();
    if (found)
    {
      change.prepared->geometry = change.surface.geode->getSharedGeometry();
    }
  }
  this->changes.clear();
  return found;
}

unsigned int PreparedSilhouette::lightBits(const Change& change, Which which)
{
  unsigned int bits = 0;
  for (const auto& [index, lightMC] : change.prepared->lights)
  {
    if (which == Which::All ||
        chooseCasting(change.surface.geode->getGeometry(), lightMC) == Casting::LightFacing)
    {
      bits |= 1u << static_cast<unsigned int>(index);
    }
  }
  return bits;
}

void PreparedSilhouette::bindFacing(vtkShaderProgram* program, const Surface& surface,
                                    const std::vector<Light>& /*lights*/)
{
  this->bindFacingTexture(static_cast<unsigned int>(program->GetHandle()), *surface.path);
}

void PreparedSilhouette::bindFacingTexture(unsigned int program, const NodePath& path) const
{
  this->getPrepared(path).facing.bind(this->getFrame().window->GetState(), program, facingUnit,
                                      "facingTexels", "facingLayer");
  glUniform1i(glGetUniformLocation(program, "firstTriangle"), 0);
}

void PreparedSilhouette::sweep()
{
  sweepUnused(this->paths, [](Entry& entry) { entry.prepared->release(false); });
  this->changes.clear();
  this->EdgeQuadSilhouette::sweep();
}

void PreparedSilhouette::release(bool contextLost)
{
  for (auto& [path, entry] : this->paths)
  {
    entry.prepared->release(contextLost);
  }
  this->paths.clear();
  this->changes.clear();
  this->EdgeQuadSilhouette::release(contextLost);
}

std::size_t PreparedSilhouette::getMemorySize() const
{
  std::size_t bytes = this->EdgeQuadSilhouette::getMemorySize();
  for (const auto& [path, entry] : this->paths)
  {
    bytes += entry.prepared->getMemorySize();
  }
  return bytes;
}

} // namespace shadow
