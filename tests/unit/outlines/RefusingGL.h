#pragma once

namespace shadow::test
{

/// While it lives, the GL says that shaders can look up so many texels of a buffer and no more.
/// @pre VTK has loaded the GL's functions
class TexelLimit
{
public:
  explicit TexelLimit(int texels);
  ~TexelLimit();
  TexelLimit(const TexelLimit&) = delete;
  TexelLimit& operator=(const TexelLimit&) = delete;
};

/// While it lives, the GL takes no framebuffer: whoever asks is told that it is not supported.
/// @pre VTK has loaded the GL's functions
class FramebufferRefusal
{
public:
  FramebufferRefusal();
  ~FramebufferRefusal();
  FramebufferRefusal(const FramebufferRefusal&) = delete;
  FramebufferRefusal& operator=(const FramebufferRefusal&) = delete;
};

/// While it lives, no shader that is new compiles, of a type or at all.
/// @pre VTK has loaded the GL's functions
class ShaderRefusal
{
public:
  /// @param type  such as GL_COMPUTE_SHADER; 0: all
  explicit ShaderRefusal(unsigned int type = 0);
  ~ShaderRefusal();
  ShaderRefusal(const ShaderRefusal&) = delete;
  ShaderRefusal& operator=(const ShaderRefusal&) = delete;
};

} // namespace shadow::test
