#pragma once

#include "OpenGL.h"

namespace shadow
{

/// Waits for the GL, so that the milliseconds of a stage are its own.
inline void finishStage(bool wait)
{
  if (wait)
  {
    glFinish();
  }
}

} // namespace shadow
