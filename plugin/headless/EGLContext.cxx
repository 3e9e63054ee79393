#include "EGLContext.h"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "EGLFunctions.h"

namespace shadow
{

namespace
{

using egl::Functions;

struct Candidate
{
  egl::Display display;
  std::string name;
};

bool isSoftware(egl::Device device)
{
  return Functions::get().queryDeviceString != nullptr &&
         egl::hasWord(Functions::get().queryDeviceString(device, egl::Extensions),
                      "EGL_MESA_device_software");
}

/// A display that belongs to us as far as EGL has such: who else opens that platform and device gets one display for the
/// whole process, and ends it for everybody, as VTK's own window does when it is deleted.
egl::Display openDisplay(unsigned int platform, egl::Device device)
{
  const Functions& functions = Functions::get();
  if (functions.hasClientExtension("EGL_KHR_display_reference"))
  {
    // Others who end it end their reference.
    const egl::Attribute counted[] = {egl::TrackReferences, 1, egl::None};
    egl::Display display = functions.getPlatformDisplay(platform, device, counted);
    if (display != nullptr)
    {
      return display;
    }
  }
  // Mesa has one display for each list of attributes, and takes one without any for another than no list.
  const egl::Attribute none[] = {egl::None};
  return functions.getPlatformDisplay(platform, device, none);
}

/// Displays that need no window system: GPUs, what Mesa finds without a device, and software.
std::vector<Candidate> listCandidates()
{
  const Functions& functions = Functions::get();
  std::vector<Candidate> gpus;
  std::vector<Candidate> software;
  if (functions.hasClientExtension("EGL_EXT_platform_device") && functions.queryDevices != nullptr)
  {
    int count = 0;
    functions.queryDevices(0, nullptr, &count);
    std::vector<egl::Device> devices(static_cast<std::size_t>(std::max(count, 0)));
    functions.queryDevices(count, devices.data(), &count);
    for (std::size_t i = 0; i < devices.size(); ++i)
    {
      (isSoftware(devices[i]) ? software : gpus)
          .push_back({openDisplay(egl::PlatformDevice, devices[i]), "device " + std::to_string(i)});
    }
  }
  std::vector<Candidate> candidates = std::move(gpus);
  if (functions.hasClientExtension("EGL_MESA_platform_surfaceless"))
  {
    candidates.push_back({openDisplay(egl::PlatformSurfaceless, nullptr), "without a surface"});
  }
  candidates.insert(candidates.end(), software.begin(), software.end());
  return candidates;
}

egl::Config chooseConfig(egl::Display display)
{
  const int attributes[] = {egl::SurfaceType,
                            egl::PbufferBit,
                            egl::RenderableType,
                            egl::OpenGLBit,
                            egl::RedSize,
                            8,
                            egl::GreenSize,
                            8,
                            egl::BlueSize,
                            8,
                            egl::AlphaSize,
                            8,
                            egl::DepthSize,
                            24,
                            egl::StencilSize,
                            8,
                            egl::None};
  egl::Config config = nullptr;
  int count = 0;
  const bool chosen = Functions::get().chooseConfig(display, attributes, &config, 1, &count) != 0;
  return chosen && count > 0 ? config : nullptr;
}

/// The highest core profile there is; VTK needs 3.2.
egl::Context createContext(egl::Display display, egl::Config config)
{
  for (const auto& version : {std::pair<int, int>{4, 6}, {4, 5}, {4, 3}, {3, 3}, {3, 2}})
  {
    const int attributes[] = {egl::ContextMajorVersion,
                              version.first,
                              egl::ContextMinorVersion,
                              version.second,
                              egl::ContextProfileMask,
                              egl::ContextCoreProfileBit,
                              egl::None};
    egl::Context context = Functions::get().createContext(display, config, nullptr, attributes);
    if (context != nullptr)
    {
      return context;
    }
  }
  return nullptr;
}

} // namespace

EGLContext::EGLContext()
{
  std::string reasons;
  for (const Candidate& candidate : listCandidates())
  {
    std::string reason;
    if (this->open(candidate.display, reason))
    {
      this->description += ", " + candidate.name;
      return;
    }
    reasons += "; " + candidate.name + ": " + reason;
  }
  throw std::runtime_error("EGL gives no OpenGL 3.2 core context without a display" +
                           (reasons.empty() ? "; it lists no device" : reasons));
}

bool EGLContext::open(void* candidate, std::string& reason)
{
  const Functions& functions = Functions::get();
  int major = 0;
  int minor = 0;
  if (candidate == nullptr || functions.initialize(candidate, &major, &minor) == 0)
  {
    reason = "cannot be opened";
    return false;
  }
  // Before 1.5 functions of GL 1.1 may be missing from eglGetProcAddress.
  const std::string version = std::to_string(major) + "." + std::to_string(minor);
  if (std::pair<int, int>{major, minor} < std::pair<int, int>{1, 5} || functions.bindAPI(egl::OpenGLApi) == 0)
  {
    reason = "EGL " + version + " without OpenGL, or before 1.5";
    return false;
  }
  egl::Config config = chooseConfig(candidate);
  const int size[] = {egl::Width, bufferSize, egl::Height, bufferSize, egl::None};
  egl::Surface newSurface =
      config != nullptr ? functions.createPbufferSurface(candidate, config, size) : nullptr;
  if (newSurface == nullptr)
  {
    reason = "no buffer with colour, depth and stencil";
    return false;
  }
  egl::Context newContext = createContext(candidate, config);
  if (newContext == nullptr)
  {
    functions.destroySurface(candidate, newSurface);
    reason = "no OpenGL 3.2 core profile";
    return false;
  }
  this->display = candidate;
  this->surface = newSurface;
  this->context = newContext;
  this->description = "EGL " + version + " of " + functions.queryString(candidate, egl::Vendor);
  return true;
}

EGLContext::~EGLContext()
{
  const Functions& functions = Functions::get();
  if (this->isCurrent())
  {
    functions.makeCurrent(this->display, nullptr, nullptr, nullptr);
  }
  functions.destroyContext(this->display, this->context);
  functions.destroySurface(this->display, this->surface);
}

bool EGLContext::makeCurrent()
{
  return this->isCurrent() ||
         Functions::get().makeCurrent(this->display, this->surface, this->surface, this->context) != 0;
}

bool EGLContext::isCurrent() const
{
  return Functions::get().getCurrentContext() == this->context;
}

std::function<void()> EGLContext::rememberCurrent() const
{
  const Functions& functions = Functions::get();
  egl::Context before = functions.getCurrentContext();
  // Nothing can be made current on a display only: on whichever.
  egl::Display on = before != nullptr ? functions.getCurrentDisplay() : this->display;
  egl::Surface draw = functions.getCurrentSurface(egl::Draw);
  egl::Surface read = functions.getCurrentSurface(egl::Read);
  return [=]
  {
    if (functions.getCurrentContext() != before)
    {
      functions.makeCurrent(on, draw, read, before);
    }
  };
}

vtkShadowGLFunction EGLContext::getFunction(const char* name)
{
  return Functions::get().getProcAddress(name);
}

} // namespace shadow
