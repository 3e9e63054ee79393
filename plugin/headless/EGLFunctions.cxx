#include "EGLFunctions.h"

#include "SharedLibrary.h"

namespace shadow::egl
{

Functions::Functions()
{
  const SharedLibrary library({"libEGL.so.1", "libEGL.so"}, "there is no EGL (Debian: libegl1)");
  library.find("eglGetProcAddress", this->getProcAddress);
  library.find("eglGetPlatformDisplay", this->getPlatformDisplay);
  library.find("eglInitialize", this->initialize);
  library.find("eglQueryString", this->queryString);
  library.find("eglBindAPI", this->bindAPI);
  library.find("eglChooseConfig", this->chooseConfig);
  library.find("eglCreatePbufferSurface", this->createPbufferSurface);
  library.find("eglDestroySurface", this->destroySurface);
  library.find("eglCreateContext", this->createContext);
  library.find("eglDestroyContext", this->destroyContext);
  library.find("eglGetCurrentContext", this->getCurrentContext);
  library.find("eglGetCurrentDisplay", this->getCurrentDisplay);
  library.find("eglGetCurrentSurface", this->getCurrentSurface);
  library.find("eglMakeCurrent", this->makeCurrent);

  this->queryDevices =
      reinterpret_cast<decltype(this->queryDevices)>(this->getProcAddress("eglQueryDevicesEXT"));
  this->queryDeviceString =
      reinterpret_cast<decltype(this->queryDeviceString)>(this->getProcAddress("eglQueryDeviceStringEXT"));
}

bool Functions::hasClientExtension(const char* name) const
{
  return hasWord(this->queryString(nullptr, Extensions), name);
}

const Functions& Functions::get()
{
  static const Functions functions;
  return functions;
}

bool hasWord(const char* words, const std::string& word)
{
  return words != nullptr && (" " + std::string(words) + " ").find(" " + word + " ") != std::string::npos;
}

} // namespace shadow::egl
