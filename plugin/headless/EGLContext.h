#ifndef EGLContext_h
#define EGLContext_h

#include "GLFunctions.h"
#include "HeadlessContext.h"

namespace shadow
{

/// A context of EGL without a display: on the first GPU that takes one, else on Mesa's software renderer.
/// libEGL is loaded when the first context is made.
class EGLContext final : public HeadlessContext
{
public:
  /// @throws std::runtime_error, with what each device said, when there is no EGL or none with OpenGL 3.2
  EGLContext();
  ~EGLContext() override;

  bool makeCurrent() override;
  bool isCurrent() const override;
  std::function<void()> rememberCurrent() const override;
  std::string getDescription() const override { return this->description; }

  static vtkShadowGLFunction getFunction(const char* name);

private:
  /// What is open when this returns true belongs to this context. @return false with a few words in @p reason
  bool open(void* candidate, std::string& reason);

  // Displays stay open, since other contexts may use them.
  void* display = nullptr;
  void* surface = nullptr;
  void* context = nullptr;
  std::string description;
};

} // namespace shadow

#endif
