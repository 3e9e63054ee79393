#include "OSMesaContext.h"

#include <cstddef>
#include <stdexcept>
#include <utility>

#include "OSMesaFunctions.h"
#include "SharedLibrary.h"

namespace shadow
{

namespace
{

struct OSMesa
{
  osmesa::CreateContextAttribs* createContextAttribs = nullptr;
  osmesa::DestroyContext* destroyContext = nullptr;
  osmesa::GetColorBuffer* getColorBuffer = nullptr;
  osmesa::GetCurrentContext* getCurrentContext = nullptr;
  osmesa::GetIntegerv* getIntegerv = nullptr;
  osmesa::GetProcAddress* getProcAddress = nullptr;
  osmesa::MakeCurrent* makeCurrent = nullptr;

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
    const int attributes[] = {osmesa::format,
                              osmesa::rgba,
                              osmesa::depthBits,
                              24,
                              osmesa::stencilBits,
                              8,
                              osmesa::profile,
                              osmesa::coreProfile,
                              osmesa::majorVersion,
                              version.first,
                              osmesa::minorVersion,
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
    osMesa().makeCurrent(nullptr, nullptr, osmesa::unsignedByte, 0, 0);
  }
  osMesa().destroyContext(this->context);
}

bool OSMesaContext::makeCurrent()
{
  return this->isCurrent() ||
         osMesa().makeCurrent(this->context, this->buffer.data(), osmesa::unsignedByte, bufferSize,
                              bufferSize) != 0;
}

bool OSMesaContext::isCurrent() const
{
  return osMesa().getCurrentContext() == this->context;
}

std::function<void()> OSMesaContext::rememberCurrent() const
{
  const osmesa::Context before = osMesa().getCurrentContext();
  void* pixels = nullptr;
  int width = 0;
  int height = 0;
  int format = 0;
  int type = static_cast<int>(osmesa::unsignedByte);
  if (before != nullptr)
  {
    osMesa().getColorBuffer(before, &width, &height, &format, &pixels);
    osMesa().getIntegerv(osmesa::type, &type);
  }
  return [=]
  {
    if (osMesa().getCurrentContext() != before)
    {
      osMesa().makeCurrent(before, pixels, static_cast<unsigned int>(type), width, height);
    }
  };
}

vtkShadowGLFunction OSMesaContext::getFunction(const char* name)
{
  return osMesa().getProcAddress(name);
}

} // namespace shadow
