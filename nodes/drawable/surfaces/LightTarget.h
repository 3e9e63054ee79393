#pragma once

#include <cstddef>
#include <string>

#include "CallerFramebuffer.h"

class vtkOpenGLRenderWindow;
class vtkOpenGLState;

namespace shadow
{

/// What one light adds to a picture: a colour buffer over the depth of the framebuffer that VTK is drawing
/// into. It is drawn by itself and then added, so that a pixel gets a light once, however many surfaces
/// coincide there.
class LightTarget
{
public:
  LightTarget() = default;
  LightTarget(const LightTarget&) = delete;
  LightTarget& operator=(const LightTarget&) = delete;

  /// Makes ready for the bound framebuffer and the viewport that is set.
  /// @return false with a line in @p error when the GL refuses, or there is no depth to share
  bool begin(vtkOpenGLState* state, std::string& error);

  /// Binds the target and clears it in the scissor's rectangle. @pre begin()
  void beginLight(vtkOpenGLState* state);

  /// Binds the framebuffer of begin() again and adds what has been drawn to its first colour buffer; alpha
  /// stays.
  /// @return false when the shader does not compile
  bool addLight(vtkOpenGLRenderWindow* window, bool hasClipControl);

  /// Lets go of the framebuffer's depth.
  void end(vtkOpenGLState* state);

  /// Frees the GL objects. @pre their context is current, or is gone and @p contextLost
  void release(bool contextLost = false);

  std::size_t getMemorySize() const; ///< bytes

private:
  bool allocate(int newWidth, int newHeight, int newSamples);

  CallerFramebuffer caller;
  unsigned int framebuffer = 0;
  unsigned int texture = 0;
  unsigned int emptyVertexArray = 0;
  int width = 0;
  int height = 0;
  int samples = 0;
};

} // namespace shadow
