// The part of ShadowVolumeEffect that draws small meshes together.
#include <algorithm>
#include <iterator>
#include <utility>

#include <vtkOpenGLRenderWindow.h>

#include "CountedFolds.h"
#include "ShadowPrograms.h"
#include "ShadowVolumeEffect.h"

namespace shadow
{

void ShadowVolumeEffect::gatherBatch(const Frame& frame)
{
  const bool wanted = (frame.settings.savings & Batches) != 0;
  std::vector<BatchedSurface> surfaces =
      this->batchCollector.collect(*this, wanted ? SurfaceBatch::findMostSurfaces() : 0);
  this->batch.update(std::move(surfaces), frame.view, this->getClipFromWC(frame.view));
  this->statistics.batchedSurfaces = this->batch.getSurfaces().size();
}

bool ShadowVolumeEffect::drawBatchedSurfaces(const Frame& frame)
{
  if (this->batch.isEmpty())
  {
    return true;
  }
  vtkShaderProgram* program = ShadowPrograms(frame.window)
                                  .use(ShadowPrograms::PrePass, frame.view.parallel, SurfaceBatch::batchSwitch);
  if (program == nullptr)
  {
    return false;
  }
  setDepthBias(program, this->depthRange.reversed, false);
  this->statistics.prePassTriangles += this->batch.drawPrePass(frame.window->GetState(), program, frame.view);
  return true;
}

bool ShadowVolumeEffect::drawBatchedVolumes(const Frame& frame, const Light& light, StencilCount count,
                                            CountedFolds& folds)
{
  if (this->batch.isEmpty())
  {
    return true;
  }
  VolumeBatch& volumes = this->volumeBatches[{light.index, count}];
  volumes.update(this->batch, light.index, count, mostCountableIn(this->countBuffer));
  if (volumes.isEmpty())
  {
    return true;
  }
  vtkShaderProgram* program = folds.open(startsAtNear(frame.view, count), SurfaceBatch::batchSwitch);
  if (program == nullptr)
  {
    return false;
  }
  volumes.draw(this->batch, {frame.window->GetState(), program, this->countBuffer, this->depthRange.reversed},
               frame.view.mirrored, [&folds](std::size_t bound) { folds.makeRoom(bound); });
  this->statistics.sideTriangles += volumes.getSides();
  this->statistics.capTriangles += volumes.getCaps();
  this->statistics.silhouetteEdges += volumes.getSilhouetteEdges();
  return true;
}

void ShadowVolumeEffect::dropUnusedBatches(const std::vector<Light>& lights)
{
  for (auto entry = this->volumeBatches.begin(); entry != this->volumeBatches.end();)
  {
    const bool used = !this->batch.isEmpty() &&
                      std::any_of(lights.begin(), lights.end(),
                                  [&](const Light& light) { return light.index == entry->first.first; });
    if (!used)
    {
      entry->second.release(false);
    }
    entry = used ? std::next(entry) : this->volumeBatches.erase(entry);
  }
}

void ShadowVolumeEffect::releaseBatches(bool contextLost)
{
  this->batch.release(contextLost);
  for (auto& [key, volumes] : this->volumeBatches)
  {
    volumes.release(contextLost);
  }
  this->volumeBatches.clear();
}

std::size_t ShadowVolumeEffect::getBatchMemorySize() const
{
  std::size_t bytes = this->batch.getMemorySize();
  for (const auto& [key, volumes] : this->volumeBatches)
  {
    bytes += volumes.getMemorySize();
  }
  return bytes;
}

} // namespace shadow
