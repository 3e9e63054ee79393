#pragma once

#include <cstddef>
#include <functional>
#include <string>

class vtkOpenGLState;
class vtkShaderProgram;

namespace shadow
{

class TexelArray;

/// Draws points into the texels of an array, layer by layer: point i into texel i.
class TexelPainter
{
public:
  TexelPainter() = default;
  TexelPainter(const TexelPainter&) = delete;
  TexelPainter& operator=(const TexelPainter&) = delete;

  /// Draws points @p first to @p first + @p count - 1 with the current program.
  using DrawPoints = std::function<void(std::size_t first, std::size_t count)>;

  /// Draws all texels.
  ///
  /// @param program  current; its ivec2 layerSize is set to width and height of a layer, where the point has
  ///                 to place itself in the middle of its texel
  /// @pre   a GLStateScope stands around this
  /// @return false with a line in @p error when the GL cannot
  bool paint(vtkOpenGLState* state, const TexelArray& texels, vtkShaderProgram* program,
             const DrawPoints& drawPoints, std::string& error);

  /// The same with points that carry nothing but their number.
  bool paint(vtkOpenGLState* state, const TexelArray& texels, vtkShaderProgram* program, std::string& error);

  /// Frees the GL objects. @pre their context is current, or is gone and @p contextLost
  void release(bool contextLost = false);

private:
  unsigned int framebuffer = 0;
  unsigned int emptyVertexArray = 0;
};

} // namespace shadow
