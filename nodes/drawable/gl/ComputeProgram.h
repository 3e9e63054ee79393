#pragma once

#include <cstddef>
#include <string>

class vtkOpenGLRenderWindow;

namespace shadow
{

/// A compute shader, compiled and linked by the GL itself, since VTK's shader cache knows no such stage.
///
/// The shader numbers its invocations by workItem() of shaders/workItem.glsl. @pre GL 4.3
class ComputeProgram
{
public:
  /// @param shaderSource  has to outlive the program
  /// @param shaderName    for messages
  /// @param mostGroups    work groups in a row at most; 0: what the GL allows
  ComputeProgram(const char* shaderSource, const char* shaderName, int mostGroups = 0)
      : source(shaderSource), name(shaderName), groupsAskedFor(mostGroups)
  {
  }
  ComputeProgram(const ComputeProgram&) = delete;
  ComputeProgram& operator=(const ComputeProgram&) = delete;

  /// Makes the program current in place of VTK's; it is compiled the first time.
  /// @return false with what the GL says in @p error when it does not compile or link; it is not tried again
  bool use(vtkOpenGLRenderWindow* window, std::string& error);

  /// Makes no program current.
  static void useNone();

  /// Name of the GL program; 0 before use().
  unsigned int getHandle() const { return this->program; }

  void setInteger(const char* uniform, int value) const;
  void setUnsigned(const char* uniform, unsigned int value) const;
  void setPair(const char* uniform, int x, int y) const;

  /// Runs it for items 0 to @p items - 1, and for a few beyond, which the shader has to ignore. Rows of work
  /// groups longer than the GL allows are broken. @pre use()
  void dispatch(std::size_t items) const;

  /// Frees the GL objects. @pre their context is current, or is gone and @p contextLost
  void release(bool contextLost = false);

private:
  bool build();

  const char* source;
  const char* name;
  int groupsAskedFor;
  unsigned int program = 0;
  int groupSize = 1;   ///< invocations
  std::string refusal; ///< what the GL says
};

} // namespace shadow
