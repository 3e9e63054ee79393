#ifndef OSMesaFunctions_h
#define OSMesaFunctions_h

// What we use of OSMesa's interface, so that its header is not needed: the library is loaded at run time, and some
// systems have neither any more. Values and signatures are fixed by the interface, version 11.2 and later.

namespace shadow::osmesa
{

using Context = void*;

inline constexpr int rgba = 0x1908; ///< GL_RGBA
inline constexpr int format = 0x22;
inline constexpr int depthBits = 0x30;
inline constexpr int stencilBits = 0x31;
inline constexpr int profile = 0x33;
inline constexpr int coreProfile = 0x34;
inline constexpr int majorVersion = 0x36;
inline constexpr int minorVersion = 0x37;
inline constexpr int type = 0x23; ///< of the colour buffer that is drawn into
inline constexpr unsigned int unsignedByte = 0x1401; ///< GL_UNSIGNED_BYTE

/// @param attributes  pairs, and a 0
using CreateContextAttribs = Context(const int* attributes, Context shared);
using DestroyContext = void(Context context);
using MakeCurrent = unsigned char(Context context, void* buffer, unsigned int type, int width, int height);
using GetCurrentContext = Context();
using GetIntegerv = void(int name, int* value);
using GetColorBuffer = unsigned char(Context context, int* width, int* height, int* format, void** buffer);
using Function = void (*)();
using GetProcAddress = Function(const char* name);

} // namespace shadow::osmesa

#endif
