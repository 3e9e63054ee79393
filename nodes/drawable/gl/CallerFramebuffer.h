#pragma once

namespace shadow
{

/// The framebuffer that VTK, or a pass above ours, is drawing into.
struct CallerFramebuffer
{
  unsigned int name = 0;
  int samples = 1;
  bool hasMoreColours = false; ///< a second draw buffer
  int depthType = 0; ///< GL_TEXTURE, GL_RENDERBUFFER, GL_FRAMEBUFFER_DEFAULT; GL_NONE: no depth
  unsigned int depthName = 0;
  int depthLevel = 0;         ///< of a texture
  int depthBits = 0;          ///< a sample
  bool hasFloatDepth = false; ///< else whole numbers
  bool hasStencil = false;    ///< in one buffer with the depth

  /// Asks the GL. @pre the framebuffer is bound for drawing
  static CallerFramebuffer query();

  /// Whether its depth can be that of another framebuffer, too.
  bool canShareDepth() const;

  /// Makes its depth that of the bound framebuffer. @pre canShareDepth()
  void attachDepth() const;

  /// The format of a texture that its depth can be copied into.
  unsigned int depthFormat() const;
};

/// Has the bound framebuffer's first draw buffer alone be written to, and puts the others back at the end:
/// what a shader with one output writes to more is undefined.
class FirstDrawBufferScope
{
public:
  FirstDrawBufferScope();
  ~FirstDrawBufferScope();
  FirstDrawBufferScope(const FirstDrawBufferScope&) = delete;
  FirstDrawBufferScope& operator=(const FirstDrawBufferScope&) = delete;

private:
  static constexpr int most = 8; ///< GL 3.2 promises as many
  unsigned int buffers[most] = {};
  int count = 0;
};

} // namespace shadow
