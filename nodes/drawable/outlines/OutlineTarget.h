#pragma once

#include <cstddef>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkShaderProgram;

namespace shadow
{

/// The render targets of outlines: depth of all surfaces and its slope for pass 1, and what of each pixel
/// lines cover for pass 2, see shaders/outlines/outlineEdge.frag.
class OutlineTarget
{
public:
  OutlineTarget() = default;
  OutlineTarget(const OutlineTarget&) = delete;
  OutlineTarget& operator=(const OutlineTarget&) = delete;

  /// Makes the targets this large; does nothing when they are.
  /// @param depthScale  pixels of pass 1 for one of the lines, in each direction
  /// @param keepsDepth  the depth of the lines is wanted, for blendDepth()
  /// @return false with a line in @p error when the GL refuses
  bool allocate(vtkOpenGLState* state, int width, int height, int depthScale, bool keepsDepth,
                std::string& error);

  /// Binds depth and slope, clears the depth, and sets GL up to draw surfaces there.
  void beginDepth(vtkOpenGLState* state, bool reversedDepth);

  /// Binds and clears the lines, and sets GL up to draw lines there: no depth test, the maximum of what
  /// covers a pixel. Binds pass 1 to texture units 0 and 1 for shaders/outlines/outlineVisibility.glsl.
  /// @pre   the program is current
  /// @param windowDepth  a texture for shaders/outlines/outlineWindow.glsl, bound to a unit of its own; or 0
  void beginLines(vtkOpenGLState* state, vtkShaderProgram* program, unsigned int windowDepth);

  /// Blends the lines over the bound framebuffer, in the viewport that is set. @pre the program is current
  /// and has the other uniforms of shaders/outlines/outlineBlend.frag
  /// @param margin  columns and rows by which the targets are wider than the viewport, on each side
  void blend(vtkOpenGLState* state, vtkShaderProgram* program, int margin);

  /// Has the bound framebuffer's depth be that of the visible lines where it is farther. @pre as blend(), the
  /// target keeps depth
  void blendDepth(vtkOpenGLState* state, vtkShaderProgram* program, int margin);

  /// 255 for each pixel that visible lines cover, else 0; bottom row first. Margins are left out.
  std::vector<unsigned char> readMask(vtkOpenGLRenderWindow* window, int margin) const;

  /// Frees the GL objects. @pre their context is current, or is gone and @p contextLost
  void release(bool contextLost = false);

  int getWidth() const { return this->width; }
  int getHeight() const { return this->height; }
  std::size_t getMemorySize() const;

private:
  unsigned int makeTexture(int scale, unsigned int internalFormat, unsigned int format,
                           unsigned int type) const;
  void setUp(vtkOpenGLState* state, unsigned int framebuffer, int scale) const;
  void drawOver(vtkOpenGLState* state, vtkShaderProgram* program, int margin) const;

  unsigned int depthFramebuffer = 0;
  unsigned int lineFramebuffer = 0;
  unsigned int depthTexture = 0;
  unsigned int slopeTexture = 0;
  unsigned int lineTexture = 0;
  unsigned int nearnessTexture = 0; ///< of lines; none unless their depth is kept
  unsigned int emptyVertexArray = 0;
  int width = 0;
  int height = 0;
  int depthScale = 1;
};

} // namespace shadow
