#pragma once

#include <cstddef>

class vtkOpenGLState;

namespace shadow
{

/// A buffer on the GPU as a shader looks it up by index: a GL_TEXTURE_BUFFER.
class BufferTexels
{
public:
  /// What a texel is.
  enum class Number
  {
    Float,
    Unsigned,
    Float4
  };

  explicit BufferTexels(Number kind) : number(kind) {}
  BufferTexels(const BufferTexels&) = delete;
  BufferTexels& operator=(const BufferTexels&) = delete;

  /// How many texels the GL can look up.
  static std::size_t findMost();

  /// Looks into a buffer that belongs to somebody else.
  /// @return false when the GL can look up fewer texels than that
  bool attach(unsigned int buffer, std::size_t texels);

  /// Binds the texels to a texture unit, and sets the program's sampler.
  /// @param program  name of a GL program that is current
  void bind(vtkOpenGLState* state, unsigned int program, int unit, const char* sampler) const;

  /// Leaves a texture unit without a buffer.
  static void unbind(vtkOpenGLState* state, int unit);

  /// Frees the GL objects. @pre their context is current, or is gone and @p contextLost
  void release(bool contextLost = false);

private:
  Number number;
  unsigned int texture = 0;
  unsigned int attached = 0; ///< the buffer
};

} // namespace shadow
