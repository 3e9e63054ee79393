#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

#include <vtkOpenGLRenderWindow.h>

#include "FaceCounter.h"
#include "ShadowPrograms.h"
#include "ShadowTarget.h"

namespace shadow
{

/// Counts the volumes of one light in as many goes as the count buffer needs.
class CountedFolds
{
public:
  CountedFolds(ShadowTarget& shadowTarget, vtkOpenGLRenderWindow* window, CountBuffer countBuffer,
               const ScreenRectangle& countedPixels, bool reversed, int lightIndex)
      : target(shadowTarget), state(window->GetState()), programs(window), buffer(countBuffer),
        pixels(countedPixels), reversedDepth(reversed), light(lightIndex)
  {
  }

  /// Has the buffer count from zero, unless it is counting.
  /// @param fromNear  see ShadowPrograms::use()
  /// @param switches  the same
  /// @return the program to draw volumes with; nullptr when it does not compile
  vtkShaderProgram* open(bool fromNear, const std::string& switches = "")
  {
    this->program = this->programs.use(this->buffer == CountBuffer::Stencil ? ShadowPrograms::VolumeInStencil
                                                                            : ShadowPrograms::VolumeInColor,
                                       fromNear, switches);
    this->startedAtNear = fromNear;
    this->programSwitches = switches;
    this->usable = this->usable && this->program != nullptr;
    if (!this->counting)
    {
      this->target.beginCount(this->state, this->pixels);
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
      this->open(this->startedAtNear, this->programSwitches);
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
  ScreenRectangle pixels;
  bool reversedDepth;
  int light;
  vtkShaderProgram* program = nullptr;
  std::size_t counted = 0;
  bool counting = false;
  bool startedAtNear = false;
  std::string programSwitches;
  bool usable = true;
};

} // namespace shadow
