#include "OSMesaContext.h"

#include <GL/osmesa.h>

#include <cstddef>
#include <utility>

namespace shadow
{

OSMesaContext::OSMesaContext()
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
    this->context = OSMesaCreateContextAttribs(attributes, nullptr);
    if (this->context != nullptr)
    {
      return;
    }
  }
}

OSMesaContext::~OSMesaContext()
{
  if (this->context != nullptr)
  {
    this->doneCurrent();
    OSMesaDestroyContext(static_cast<::OSMesaContext>(this->context));
  }
}

bool OSMesaContext::makeCurrent(int newWidth, int newHeight)
{
  if (this->context == nullptr)
  {
    return false;
  }
  if (this->isCurrent() && newWidth == this->width && newHeight == this->height)
  {
    return true;
  }
  this->buffer.resize(std::size_t{4} * static_cast<std::size_t>(newWidth) *
                      static_cast<std::size_t>(newHeight));
  this->width = newWidth;
  this->height = newHeight;
  return OSMesaMakeCurrent(static_cast<::OSMesaContext>(this->context), this->buffer.data(), GL_UNSIGNED_BYTE,
                           newWidth, newHeight) == GL_TRUE;
}

bool OSMesaContext::isCurrent() const
{
  return this->context != nullptr && OSMesaGetCurrentContext() == this->context;
}

OSMesaContext::Function OSMesaContext::getFunction(void* /*unused*/, const char* name)
{
  return OSMesaGetProcAddress(name);
}

void OSMesaContext::doneCurrent()
{
  if (this->isCurrent())
  {
    OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  }
}

} // namespace shadow
