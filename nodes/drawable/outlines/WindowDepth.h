#pragma once

#include <cstddef>
#include <string>

class vtkOpenGLState;

namespace shadow
{

/// A copy of the depth of what VTK has drawn, to be looked up.
class WindowDepth
{
public:
  WindowDepth() = default;
  WindowDepth(const WindowDepth&) = delete;
  WindowDepth& operator=(const WindowDepth&) = delete;

  /// Copies the depth of the bound framebuffer, in the viewport that is set; of several samples a pixel one.
  /// @post  the scissor test is off
  /// @return false with a line in @p error when the GL refuses
  bool copy(vtkOpenGLState* state, std::string& error);

  unsigned int getTexture() const { return this->texture; }

  /// Frees the GL objects. @pre their context is current, or is gone and @p contextLost
  void release(bool contextLost = false);

  std::size_t getMemorySize() const; ///< bytes

private:
  bool allocate(vtkOpenGLState* state, int newWidth, int newHeight, unsigned int newFormat);

  unsigned int framebuffer = 0;
  unsigned int texture = 0;
  unsigned int format = 0;
  int width = 0;
  int height = 0;
};

} // namespace shadow
