#include "OSMesaContext.h"

#include <GL/osmesa.h>

#include <cstddef>
#include <stdexcept>
#include <utility>

#include "SharedLibrary.h"

namespace shadow
{

namespace
{

struct OSMesa
{
  decltype(&OSMesaCreateContextAttribs) createContextAttribs = nullptr;
  decltype(&OSMesaDestroyContext) destroyContext = nullptr;
  decltype(&OSMesaGetColorBuffer) getColorBuffer = nullptr;
  decltype(&OSMesaGetCurrentContext) getCurrentContext = nullptr;
  decltype(&OSMesaGetIntegerv) getIntegerv = nullptr;
  decltype(&OSMesaGetProcAddress) getProcAddress = nullptr;
  decltype(&OSMesaMakeCurrent) makeCurrent = nullptr;

  OSMesa()
  {
    const SharedLibrary library({"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"},
                                "there is no OSMesa (Debian: libosmesa6)");
    library.find("OSMesaCreateContextAttribs", this->createContextAttribs);
    library.find("OSMesaDestroyContext", this->destroyContext);
    library.find("OSMesaGetColorBuffer", this->getColorBuffer);
    library.find("OSMesaGetCurrentContext", this->getCurrentContext);
    library.find("OSMesaGetIntegerv", this->getIntegerv);
    library.find("OSMesaGetProcAddress", this->getProcAddress);
    library.find("OSMesaMakeCurrent", this->makeCurrent);
  }
};

const OSMesa& osMesa()
{
  static const OSMesa functions;
  return functions;
}

} // namespace

OSMesaContext::OSMesaContext()
    : buffer(std::size_t{4} * static_cast<std::size_t>(bufferSize) * static_cast<std::size_t>(bufferSize))
{
  // The highest core profile OSMesa gives; VTK needs 3.2.
  for (const auto& version : {std::pair<int, int>{4, 5}, {3, 3}, {3, 2}})
  {
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              24,
                              OSMESA_STENCIL_BITS,
                              8,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              version.first,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              version.second,
                              0};
    this->context = osMesa().createContextAttribs(attributes, nullptr);
    if (this->context != nullptr)
    {
      return;
    }
  }
  throw std::runtime_error("OSMesa gives no OpenGL 3.2 core context");
}

OSMesaContext::~OSMesaContext()
{
  if (this->isCurrent())
  {
    osMesa().makeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  }
  osMesa().destroyContext(static_cast<::OSMesaContext>(this->context));
}

bool OSMesaContext::makeCurrent()
{
  return this->isCurrent() ||
         osMesa().makeCurrent(static_cast<::OSMesaContext>(this->context), this->buffer.data(),
                              GL_UNSIGNED_BYTE, bufferSize, bufferSize) == GL_TRUE;
}

bool OSMesaContext::isCurrent() const
{
  return osMesa().getCurrentContext() == this->context;
}

std::function<void()> OSMesaContext::rememberCurrent() const
{
  ::OSMesaContext before = osMesa().getCurrentContext();
  void* pixels = nullptr;
  GLint width = 0;
  GLint height = 0;
  GLint format = 0;
  GLint type = GL_UNSIGNED_BYTE;
  if (before != nullptr)
  {
    osMesa().getColorBuffer(before, &width, &height, &format, &pixels);
    osMesa().getIntegerv(OSMESA_TYPE, &type);
  }
  return [=]
  {
    if (osMesa().getCurrentContext() != before)
    {
      osMesa().makeCurrent(before, pixels, static_cast<GLenum>(type), width, height);
    }
  };
}

vtkShadowGLFunction OSMesaContext::getFunction(const char* name)
{
  return osMesa().getProcAddress(name);
}

} // namespace shadow
