#ifndef OSMesaContext_h
#define OSMesaContext_h

#include <vector>

namespace shadow
{

/// An OSMesa core-profile context with a colour buffer of its own. Knows nothing of VTK: GL/osmesa.h and
/// VTK's GL loader cannot be included in one file.
class OSMesaContext
{
public:
  OSMesaContext();
  ~OSMesaContext();
  OSMesaContext(const OSMesaContext&) = delete;
  OSMesaContext& operator=(const OSMesaContext&) = delete;

  bool isUsable() const { return this->context != nullptr; }

  /// Makes the context current with a buffer of this many pixels. @return false when OSMesa refuses
  bool makeCurrent(int width, int height);
  bool isCurrent() const;

  /// The address of a GL function, as GL loaders ask for it.
  using Function = void (*)();
  static Function getFunction(void* unused, const char* name);

  /// Makes no context current if this one is.
  void doneCurrent();

private:
  void* context = nullptr;
  std::vector<unsigned char> buffer; ///< RGBA; VTK draws into framebuffers of its own and blits here
  int width = 0;
  int height = 0;
};

} // namespace shadow

#endif
