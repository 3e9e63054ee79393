#ifndef OSMesaContext_h
#define OSMesaContext_h

#include <vector>

#include "GLFunctions.h"
#include "HeadlessContext.h"

namespace shadow
{

/// A context of OSMesa, Mesa's renderer in software. The library is loaded when the first context is made.
class OSMesaContext final : public HeadlessContext
{
public:
  /// @throws std::runtime_error when there is no OSMesa, or none with OpenGL 3.2
  OSMesaContext();
  ~OSMesaContext() override;

  bool makeCurrent() override;
  bool isCurrent() const override;
  std::function<void()> rememberCurrent() const override;
  std::string getDescription() const override { return "OSMesa"; }

  /// @pre a context has been made
  static vtkShadowGLFunction getFunction(const char* name);

private:
  void* context = nullptr;
  std::vector<unsigned char> buffer; ///< RGBA
};

} // namespace shadow

#endif
