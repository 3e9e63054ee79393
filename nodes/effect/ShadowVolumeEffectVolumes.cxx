// The stage of ShadowVolumeEffect that counts volumes.
#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include <vtkOpenGLRenderWindow.h>

#include "SVStateVisitor.h"
#include "ShadowPrograms.h"
#include "ShadowVolumeEffect.h"

namespace shadow
{

namespace
{

/// Counts the volumes of one light in as many goes as the count buffer needs.
class CountedFolds
{
public:
  CountedFolds(ShadowTarget& shadowTarget, vtkOpenGLRenderWindow* window, CountBuffer countBuffer,
               bool reversed, int lightIndex)
      : target(shadowTarget), state(window->GetState()), programs(window), buffer(countBuffer),
        reversedDepth(reversed), light(lightIndex)
  {
  }

  /// Has the buffer count from zero, unless it is counting.
  /// @param fromNear  see ShadowPrograms::use()
  /// @return the program to draw volumes with; nullptr when it does not compile
  vtkShaderProgram* open(bool fromNear)
  {
    this->program = this->programs.use(this->buffer == CountBuffer::Stencil ? ShadowPrograms::VolumeInStencil
                                                                            : ShadowPrograms::VolumeInColor,
                                       fromNear);
    this->startedAtNear = fromNear;
    this->usable = this->usable && this->program != nullptr;
    if (!this->counting)
    {
      this->target.beginCount(this->state);
      this->counting = true;
    }
    return this->usable ? this->program : nullptr;
  }

  /// Before a volume that no pixel counts more than @p bound faces of. A stencil counts modulo 256: what is
  /// drawn between two folds can never come to 256 on any pixel.
  void makeRoom(std::size_t bound)
  {
    if (this->counted + bound > mostCountableIn(this->buffer) && this->counted > 0)
    {
      this->fold();
      this->open(this->startedAtNear);
    }
    // What was drawn has to be folded, whatever its bound.
    this->counted += std::max<std::size_t>(bound, 1);
  }

  /// Takes what has been counted out of the mask. @return false when a shader did not compile
  bool finish()
  {
    if (this->usable && this->counted > 0)
    {
      this->fold();
    }
    return this->usable;
  }

private:
  void fold()
  {
    this->usable =
        this->target.foldCount(this->state, this->programs, this->light, this->reversedDepth) && this->usable;
    this->counted = 0;
    this->counting = false;
  }

  ShadowTarget& target;
  vtkOpenGLState* state;
  ShadowPrograms programs;
  CountBuffer buffer;
  bool reversedDepth;
  int light;
  vtkShaderProgram* program = nullptr;
  std::size_t counted = 0;
  bool counting = false;
  bool startedAtNear = false;
  bool usable = true;
};

} // namespace

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
  CountedFolds folds(this->target, frame.window, this->countBuffer, this->depthRange.reversed,
                     light.index);
  for (const StencilCount count : {StencilCount::ZPass, StencilCount::ZFail})
  {
    SVStateVisitor volumeMode(RenderMode{RenderMode::What::Volume, light.index, count});
    this->accept(volumeMode);
    vtkShaderProgram* program = folds.open(startsAtNear(frame.view, count));
    if (program == nullptr)
    {
      break;
    }
    DrawVisitor::Pass pass = this->makeDrawPass(program, frame);
    pass.makeRoom = [&folds](std::size_t bound) { folds.makeRoom(bound); };
    DrawVisitor draw(pass);
    this->accept(draw);
    this->statistics.sideTriangles += draw.getCounts().sides;
    this->statistics.capTriangles += draw.getCounts().caps;
    this->statistics.silhouetteEdges += draw.getCounts().silhouetteEdges;
  }
  const bool usable = folds.finish();
  error = usable ? error : unusableShader;
  return usable;
}

} // namespace shadow
