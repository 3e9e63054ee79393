#ifndef HeadlessContext_h
#define HeadlessContext_h

#include <functional>
#include <memory>
#include <string>

namespace shadow
{

/// A GL core-profile context, at least 3.2, that needs no display. Knows nothing of VTK.
class HeadlessContext
{
public:
  HeadlessContext() = default;
  virtual ~HeadlessContext() = default;
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

  /// @return false when the GL refuses
  virtual bool makeCurrent() = 0;
  virtual bool isCurrent() const = 0;

  /// What the calling thread draws into now: this context, any other of the same GL, or none.
  /// @return makes that current again, in this thread, as long as this context and that one exist
  virtual std::function<void()> rememberCurrent() const = 0;

  /// Where it comes from, for people: "OSMesa", "EGL 1.5 of NVIDIA, device 0".
  virtual std::string getDescription() const = 0;

  /// Pixels on a side of the buffer behind a context. VTK draws into framebuffers of its own and shows
  /// nothing here; a small one keeps memory low.
  static constexpr int bufferSize = 16;
};

/// A context of the GL that the environment variable VTKSHADOW_HEADLESS names: osmesa, in software, or egl, a
/// GPU where there is one; when it is not set, of @p preferred, else of the other. The first call that succeeds
/// decides for the whole process, because GL functions are looked up only once.
///
/// @return null, with a line in @p error, when there is no such GL or it has no OpenGL 3.2 core profile
std::unique_ptr<HeadlessContext> makeHeadlessContext(const std::string& preferred, std::string& error);

} // namespace shadow

#endif
