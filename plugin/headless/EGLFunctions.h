#ifndef EGLFunctions_h
#define EGLFunctions_h

#include <cstdint>
#include <string>

#include "GLFunctions.h"

namespace shadow::egl
{

// As much of EGL 1.5 as a context without a display needs, with the registry's numbers: Debian has EGL's
// header in a package that VTK does not need.

using Display = void*;
using Device = void*;
using Config = void*;
using Surface = void*;
using Context = void*;
using Attribute = std::intptr_t;

enum : int
{
  None = 0x3038,
  OpenGLApi = 0x30A2,
  Vendor = 0x3053,
  Extensions = 0x3055,
  SurfaceType = 0x3033,
  PbufferBit = 0x0001,
  RenderableType = 0x3040,
  OpenGLBit = 0x0008,
  RedSize = 0x3024,
  GreenSize = 0x3023,
  BlueSize = 0x3022,
  AlphaSize = 0x3021,
  DepthSize = 0x3025,
  StencilSize = 0x3026,
  Width = 0x3057,
  Height = 0x3056,
  Draw = 0x3059,
  Read = 0x305A,
  ContextMajorVersion = 0x3098,
  ContextMinorVersion = 0x30FB,
  ContextProfileMask = 0x30FD,
  ContextCoreProfileBit = 0x0001,
  PlatformDevice = 0x313F,      ///< EGL_EXT_platform_device
  PlatformSurfaceless = 0x31DD, ///< EGL_MESA_platform_surfaceless
  TrackReferences = 0x3352      ///< EGL_KHR_display_reference
};

/// The functions of libEGL, which is loaded with the first use.
struct Functions
{
  vtkShadowGLFunction (*getProcAddress)(const char* name);
  Display (*getPlatformDisplay)(unsigned int platform, void* native, const Attribute* attributes);
  unsigned int (*initialize)(Display, int* major, int* minor);
  const char* (*queryString)(Display, int name);
  unsigned int (*bindAPI)(unsigned int api);
  unsigned int (*chooseConfig)(Display, const int* attributes, Config*, int size, int* count);
  Surface (*createPbufferSurface)(Display, Config, const int* attributes);
  unsigned int (*destroySurface)(Display, Surface);
  Context (*createContext)(Display, Config, Context shared, const int* attributes);
  unsigned int (*destroyContext)(Display, Context);
  Context (*getCurrentContext)();
  Display (*getCurrentDisplay)();
  Surface (*getCurrentSurface)(int readOrDraw);
  unsigned int (*makeCurrent)(Display, Surface draw, Surface read, Context);

  // Of EGL_EXT_device_enumeration and EGL_EXT_device_query; null where these are not there.
  unsigned int (*queryDevices)(int size, Device*, int* count);
  const char* (*queryDeviceString)(Device, int name);

  /// Whether libEGL itself, rather than a display of it, has an extension.
  bool hasClientExtension(const char* name) const;

  /// @throws std::runtime_error when there is no libEGL, or one before EGL 1.5
  static const Functions& get();

private:
  Functions();
};

/// Whether a list of words, or a null pointer, has this word.
bool hasWord(const char* words, const std::string& word);

} // namespace shadow::egl

#endif
