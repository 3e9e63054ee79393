// The stage of ShadowVolumeEffect that counts volumes.
#include <map>
#include <optional>
#include <utility>

#include "CountedFolds.h"
#include "SVStateVisitor.h"
#include "ShadowVolumeEffect.h"

namespace shadow
{

bool ShadowVolumeEffect::countVolumes(const Frame& frame, std::string& error)
{
  const std::map<int, VolumeCounts> countsBefore = std::exchange(this->countsOfLight, {});
  Statistics& sum = this->statistics;
  for (const Light& light : frame.lights)
  {
    VolumeCounts& counts = this->countsOfLight[light.index];
    if (const std::optional<int> before = this->kept.findBefore(light.index))
    {
      counts = countsBefore.at(*before);
      sum.sideTriangles += counts.sideTriangles;
      sum.capTriangles += counts.capTriangles;
      sum.silhouetteEdges += counts.silhouetteEdges;
      sum.keptLights += 1;
      continue;
    }
    const VolumeCounts others = sum;
    if (!this->drawVolumes(frame, light, error))
    {
      return false;
    }
    counts = {sum.sideTriangles - others.sideTriangles, sum.capTriangles - others.capTriangles,
              sum.silhouetteEdges - others.silhouetteEdges};
  }
  return true;
}

bool ShadowVolumeEffect::drawVolumes(const Frame& frame, const Light& light, std::string& error)
{
  CountedFolds folds(this->target, frame.window, this->countBuffer, this->counted, this->depthRange.reversed,
                     light.index);
  for (const StencilCount count : {StencilCount::ZPass, StencilCount::ZFail})
  {
    if (!this->drawVolumesAlone(frame, light, count, folds) ||
        !this->drawBatchedVolumes(frame, light, count, folds))
    {
      break;
    }
  }
  const bool usable = folds.finish();
  error = usable ? error : unusableShader;
  return usable;
}

bool ShadowVolumeEffect::drawVolumesAlone(const Frame& frame, const Light& light, StencilCount count,
                                          CountedFolds& folds)
{
  if (!this->batchCollector.hasVolumesAlone(light.index, count))
  {
    return true;
  }
  SVStateVisitor volumeMode(RenderMode{RenderMode::What::Volume, light.index, count});
  this->accept(volumeMode);
  vtkShaderProgram* program = folds.open(startsAtNear(frame.view, count));
  if (program == nullptr)
  {
    return false;
  }
  DrawVisitor::Pass pass = this->makeDrawPass(program, frame);
  pass.makeRoom = [&folds](std::size_t bound) { folds.makeRoom(bound); };
  DrawVisitor draw(pass);
  this->accept(draw);
  this->statistics.sideTriangles += draw.getCounts().sides;
  this->statistics.capTriangles += draw.getCounts().caps;
  this->statistics.silhouetteEdges += draw.getCounts().silhouetteEdges;
  return true;
}

} // namespace shadow
